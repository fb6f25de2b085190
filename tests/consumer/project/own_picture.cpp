// A picture from outside the library.
#include <verdigris/behaviours/voronoi_growth.hpp>
#include <verdigris/gl/renderer.hpp>
#include <verdigris/io/read_mesh.hpp>
#include <verdigris/io/write_png.hpp>
#include <verdigris/picture/regions.hpp>

#include <set>

using namespace verdigris;

int main() {
  const Mesh mesh = read_mesh("bunny.obj");
  const Surface surface = make_surface(mesh, {.cell_size = cell_size_for(mesh, 20000)});
  VoronoiGrowth growth({surface, 7, random_seeds(surface, 12, 7), {}}, {});
  while (!growth.finished()) growth.step();
  const Field<std::int32_t> labels = growth.labels();
  ViewSettings settings;
  settings.width = 320;
  settings.height = 240;
  const Image image = render(surface, colour_labels(surface, labels, label_colours(surface, labels)),
                             frame_mesh(mesh, "iso", settings));
  write_png(image, "picture.png");

  // Regions, light and background: many colours.
  std::set<std::uint32_t> colours;
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    colours.insert(
        static_cast<std::uint32_t>(image.rgba[k] << 16 | image.rgba[k + 1] << 8 | image.rgba[k + 2]));
  return colours.size() > 100 ? 0 : 1;
}
