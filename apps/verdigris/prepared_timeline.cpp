#include "prepared_timeline.hpp"

#include <utility>

#include "masks.hpp"
#include "picture.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_material.hpp"

using namespace verdigris;

void check_timeline_scene(const Scene& scene) {
  if (scene.torus.width != 0)
    throw InputError(scene.file.string(), "a flat torus does not weather", "name a model");
  static_cast<void>(find_material(scene.weathering.material));
  if (scene.picture.draw) check_picture(scene.picture);
  check_masks(scene);
}

namespace {

// Reads the model before the surface is laid on it, and says so.
LoadedModel read_model(Scene& scene, Progress& progress) {
  progress.stage("reading");
  LoadedModel model = load_model(scene);
  progress.stage("building surface");
  return model;
}

}  // namespace

PreparedTimeline::PreparedTimeline(Scene& scene, Progress& progress, bool quiet)
    : scene_(scene),
      material_(find_material(scene.weathering.material)),
      model_(read_model(scene, progress)),
      surface_(lay_cells(std::move(model_.mesh), scene)),
      sources_(surface_, scene.picture.up, scene.seed),
      masks_(sources_, all_masks(sources_, scene, model_.read)) {
  check_coverage(surface_, quiet);
}

CoatedMetal PreparedTimeline::metal() const {
  return make_coated_metal(surface_, material_);
}

std::vector<TimelineRecord> PreparedTimeline::run(CoatedMetal& metal, const TimelineListener& listener) {
  return run_timeline(builtin_operators(), surface_, metal, scene_.weathering.timeline, masks_, scene_.seed,
                      listener);
}
