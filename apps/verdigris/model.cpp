#include "model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/surface/flat_torus.hpp"

using namespace verdigris;

LoadedModel load_model(Scene& scene) {
  LoadedModel loaded;
  if (scene.torus.width != 0) return loaded;
  loaded.mesh = read_mesh(scene.mesh, &loaded.read);
  const std::string hash = mesh_hash(loaded.mesh);
  if (!scene.mesh_hash.empty() && scene.mesh_hash != hash)
    throw InputError(
        scene.mesh.string(),
        fmt::format("is not the mesh of this scene: its hash is {}, not {}", hash, scene.mesh_hash),
        "find the model the scene was made with, or remove `hash` from the scene to run it on this one");
  scene.mesh_hash = hash;
  if (scene.mend) loaded.mesh = mend(loaded.mesh, &loaded.mended);
  if (!(mesh_area(loaded.mesh) > 0.0))
    throw InputError(scene.mesh.string(), "its faces have no area", "choose a model with a surface");
  return loaded;
}

Surface lay_cells(Mesh mesh, Scene& scene) {
  if (scene.torus.width != 0) {
    scene.cell_size = 1.0;
    return make_flat_torus(scene.torus.width, scene.torus.height, scene.torus.patch, scene.links);
  }
  if (scene.cell_size <= 0.0) scene.cell_size = cell_size_for(mesh, scene.cells);
  Surface surface = make_surface(std::move(mesh), {scene.cell_size, scene.links, scene.barrier.angle});
  if (surface.owned_count() == 0)
    throw InputError(
        scene.mesh.string(),
        fmt::format("cells of {:g} are too large for its triangles: none has the centre of a cell in it",
                    scene.cell_size),
        "use smaller cells (--cell-size), or more of them (--cells)");
  return surface;
}

double check_coverage(const Surface& surface, bool quiet) {
  const double cells = static_cast<double>(surface.owned_count()),
               patches = static_cast<double>(surface.patch_count());
  const double coverage = cells * surface.cell_size() * surface.cell_size() / mesh_area(surface.mesh());
  if (std::abs(coverage - 1.0) > 0.02 && !quiet)
    say("warning: the cells cover {:.1f} % of the area: with {:.1f} cells a triangle their number is off, "
        "and areas with it; use smaller cells (--cells {:.0f})\n",
        100.0 * coverage, cells / patches, std::max(2.0 * cells, 14.0 * patches));
  return coverage;
}

std::string model_name(const Scene& scene) {
  if (scene.torus.width != 0) return fmt::format("flat torus {} x {}", scene.torus.width, scene.torus.height);
  return scene.mesh.filename().string();
}
