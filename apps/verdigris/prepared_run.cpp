#include "prepared_run.hpp"

#include <fmt/format.h>

#include "corrosion_results.hpp"
#include "masks.hpp"
#include "picture.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

void check_scene(const Scene& scene, const BehaviourEntry& behaviour) {
  const std::string owner =
      scene.file.empty() ? behaviour.name : fmt::format("{}: {}", scene.file.string(), behaviour.name);
  check_parameters(owner, behaviour.parameters, scene.parameters);
  if (scene.picture.draw) check_picture(scene.picture);
  check_masks(scene, behaviour);
  if (behaviour.needs_seeds && scene.seeds.empty())
    throw InputError("seeds", fmt::format("{} needs some", behaviour.name),
                     "give --seeds, or [seeds] in the scene");
}

void complete_scene(Scene& scene, const BehaviourEntry& behaviour) {
  ParameterValues all;
  for (const ParameterInfo& p : behaviour.parameters) {
    all.emplace_back(p.name, p.default_value);
    for (const auto& [name, value] : scene.parameters)
      if (name == p.name) all.back().second = value;
  }
  scene.parameters = std::move(all);
  if (scene.steps == 0) scene.steps = behaviour.default_steps;
}

namespace {

// Reads the model before the surface is laid on it, and says so.
LoadedModel read_model(Scene& scene, Progress& progress, const std::function<void(const char*)>& lap) {
  progress.stage("reading");
  LoadedModel model = load_model(scene);
  if (!scene.corrosion.empty() && scene.corrosion.unit_mm == 0.0)
    scene.corrosion.unit_mm = guessed_unit_mm(model.mesh);
  lap("read");
  progress.stage("building surface");
  return model;
}

}  // namespace

PreparedRun::PreparedRun(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet,
                         const std::function<void(const char* stage)>& lap)
    : model(read_model(scene, progress, lap)),
      surface(lay_cells(std::move(model.mesh), scene)),
      coverage(check_coverage(surface, quiet)),
      setup{surface, scene.seed} {
  lap("build");
  setup.masks = make_masks(surface, scene, behaviour, model.read);
  setup.barrier = take_barrier(setup.masks, surface, scene, model.read);
  placed = place_seeds(surface, scene, model.read.file_vertices, setup.barrier);
  setup.seeds = placed.seeds;
  lap("place_seeds");
  simulation = behaviour.create(setup, scene.parameters);
}
