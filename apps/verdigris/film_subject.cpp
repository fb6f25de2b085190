#include "film_subject.hpp"

#include <fmt/format.h>

#include <chrono>

#include "corrosion_results.hpp"
#include "film_subjects.hpp"
#include "picture.hpp"
#include "prepared_run.hpp"
#include "prepared_timeline.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"

using namespace verdigris;

namespace {

std::string count_of(double number, int digits, const char* unit) {
  const std::string text = fmt::format("{:.{}f}", number, digits);
  return fmt::format("{} {}{}", text, unit, text == "1" ? "" : "s");
}

}  // namespace

std::string FilmSubject::time_text(double years, double total) const {
  if (total >= 20.0) return count_of(years, 0, "year");
  if (total >= 2.0) return count_of(years, 1, "year");
  if (total >= 0.2) return count_of(12.0 * years, 1, "month");
  return count_of(365.25 * years, total >= 0.02 ? 0 : 2, "day");
}

bool grow_to(AnySimulation& simulation, std::uint64_t last, Progress& progress, double& seconds) {
  const auto begin = std::chrono::steady_clock::now();
  progress.stage("growing");
  while (last == 0 ? !simulation.finished() : simulation.steps() < last) {
    if (interrupted()) return false;
    simulation.step();
    progress.update(last == 0 ? 0.0 : static_cast<double>(simulation.steps()) / static_cast<double>(last),
                    fmt::format("step {}", simulation.steps()));
  }
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return true;
}

std::vector<FilmMoment> film_moments_of(const AnimationPlan& plan, const std::vector<double>& years) {
  return plan.years.empty() ? film_schedule(years, plan.frames, plan.hold) : film_moments(years, plan.years);
}

void prepare_film(Scene& scene) {
  if (scene.torus.width != 0)
    throw InputError(scene.file.string(), "a flat torus has no views to film", "name a model");
  if (!scene.picture.draw)
    throw InputError(scene.file.string(), "a film needs pictures, and the scene draws none",
                     "write draw = true under [picture], or remove it");
  check_picture(scene.picture);
  for (const CameraPlan& view : scene.animation.camera) view_direction(view.view, up_axis(scene.picture));
  if (!scene.weathering.empty()) {
    check_timeline_scene(scene);
    film_moments_of(scene.animation, timeline_years(builtin_operators(), scene.weathering.timeline));
    return;
  }
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  if (!scene.corrosion.empty()) static_cast<void>(prepare_corrosion(scene));
  check_scene(scene, behaviour);
  complete_scene(scene, behaviour);
  if (scene.steps == 0) return;
  const double step = scene.corrosion.empty() ? 1.0 : scene.corrosion.step_years;
  film_moments_of(scene.animation, {static_cast<double>(scene.steps) * step});
}

std::unique_ptr<FilmSubject> make_film_subject(Scene& scene, Progress& progress, bool quiet) {
  if (!scene.weathering.empty()) return weathering_film(scene, progress, quiet);
  static const Catalogue catalogue = builtin_catalogue();  // outlives the film, which makes runs anew
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  if (!scene.corrosion.empty()) return corrosion_film(scene, behaviour, progress, quiet);
  return steps_film(scene, behaviour, progress, quiet);
}
