#include <verdigris/behaviours/voronoi_growth.hpp>
#include <verdigris/io/read_mesh.hpp>
#include <verdigris/io/write_cells.hpp>
using namespace verdigris;

int main() {
  const Mesh mesh = read_mesh("bunny.obj");
  const Surface surface = make_surface(mesh, {.cell_size = cell_size_for(mesh, 1e6)});
  VoronoiGrowth growth({surface, 7, random_seeds(surface, 64, 7), {}}, {});
  while (!growth.finished()) growth.step();
  const Field<std::int32_t> labels = growth.labels();
  const CellArray arrays[] = {{"label", &labels}};
  write_cells_vtp("cells.vtp", surface, arrays);
}
