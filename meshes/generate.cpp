// Writes the models of this folder: verdigris_meshes OUTDIR. Each is checked before it is written.

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "check.hpp"
#include "cup.hpp"
#include "sheet.hpp"
#include "solids.hpp"
#include "statues.hpp"
#include "terrain.hpp"

namespace verdigris::meshes {
namespace {

struct Model {
  const char* name;
  const char* title;  // the first line of the file
  Mesh mesh;
  std::size_t triangles;
  bool closed;
  long euler;
};

std::vector<Model> models() {
  return {
      {"cup", "coffee cup with a handle, closed, millimetres, y up", make_cup(), 444, true, 0},
      {"lowpoly", "twisted faceted vase, closed, y up", make_vase(), 50, true, 2},
      {"cube", "unit cube, closed", make_cube(), 12, true, 2},
      {"sphere", "unit sphere, icosahedron split three times, closed", make_sphere(3), 1280, true, 2},
      {"torus", "torus of radii 1 and 0.4, closed", make_torus(1.0, 0.4, 48, 16), 1536, true, 0},
      {"sheet", "unit square, irregular Delaunay triangulation, open", make_sheet(10), 200, false, 1},
      {"cylinder", "fine cylinder of long thin triangles, radius 0.02, length 2, closed",
       make_cylinder(0.02, 2.0, 12), 48, true, 2},
      {"terrain", "eroded mountains, 65 x 65 heights, metres, y up, open", make_terrain(), 8192, false, 1},
      {"anchor", "admiralty anchor, closed, metres, y up", make_anchor(), 18000, true, 0},
      {"bear", "bear on a plinth, closed, decimetres, y up", make_bear(), 30000, true, -6},
      {"roof", "gabled roof with standing seams and a chimney, closed, metres, y up", make_roof(), 3836, true,
       2},
  };
}

/// To what the file holds: nine digits at most and no negative zero, where the last bits of sin and cos do
/// not reach.
void round_positions(Mesh& mesh) {
  for (auto& position : mesh.positions) {
    for (int k = 0; k < 3; ++k) position[k] = std::round(position[k] * 1e6) / 1e6 + 0.0;
  }
}

Shape checked_shape(const Model& model) {
  const Shape shape = inspect(model.mesh);
  const bool closed = shape.boundary_edges == 0;
  if (shape.triangles != model.triangles || closed != model.closed || shape.euler != model.euler ||
      shape.pieces != 1 || (closed && shape.volume <= 0)) {
    throw std::runtime_error(
        fmt::format("{} triangles, {} boundary edges, {} pieces, Euler characteristic {}, "
                    "volume {}: not what it should be",
                    shape.triangles, shape.boundary_edges, shape.pieces, shape.euler, shape.volume));
  }
  return shape;
}

void write_obj(const Model& model, const std::filesystem::path& path) {
  std::ofstream file(path, std::ios::binary);
  file << fmt::format("# {}\n", model.title);
  for (const auto& p : model.mesh.positions) file << fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  for (const auto& t : model.mesh.triangles) file << fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

void generate(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (Model& model : models()) {
    try {
      round_positions(model.mesh);
      const Shape shape = checked_shape(model);
      write_obj(model, folder / fmt::format("{}.obj", model.name));
      fmt::print(
          "{:9} {:5} triangles, {:3} boundary edges, Euler {}, area {:.6g}, volume {:.6g}, "
          "sharpest corner {:.1f} degrees\n",
          model.name, shape.triangles, shape.boundary_edges, shape.euler, shape.area, shape.volume,
          shape.least_angle);
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: {}", model.name, error.what()));
    }
  }
}

}  // namespace
}  // namespace verdigris::meshes

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: verdigris_meshes OUTDIR\n");
    return 2;
  }
  try {
    verdigris::meshes::generate(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "verdigris_meshes: {}\n", error.what());
    return 1;
  }
}
