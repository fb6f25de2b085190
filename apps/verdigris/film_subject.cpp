#include "film_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "corrosion_pictures.hpp"
#include "corrosion_results.hpp"
#include "masks.hpp"
#include "picture.hpp"
#include "prepared_run.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/io/read_material.hpp"
#include "weather_job.hpp"
#include "weather_pictures.hpp"

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

namespace {

// A timeline, made anew each time it is looked at.
class WeatheringFilm final : public FilmSubject {
 public:
  WeatheringFilm(Scene& scene, Progress& progress, bool quiet)
      : scene_(scene),
        material_(find_material(scene.weathering.material)),
        model_(read(scene, progress)),
        surface_(lay_cells(std::move(model_.mesh), scene)),
        masks_(surface_, weathering_masks(surface_, scene, model_.read), scene.picture.up, scene.seed) {
    check_coverage(surface_, quiet);
  }

  const Mesh& mesh() const override { return surface_.mesh(); }
  std::vector<double> years() const override {
    return timeline_years(builtin_operators(), scene_.weathering.timeline);
  }

  FilmCurve curve(const std::vector<FilmMoment>& moments, Progress& progress) override {
    progress.stage("rehearsing");
    FilmCurve curve{{}, [](double value) { return fmt::format("{:.3g} µm of metal lost", value); }};
    const bool whole = run(moments, [&](std::size_t k, const CoatedMetal& metal) {
      curve.points.emplace_back(moments[k].years, measure(surface_, metal).loss);
      progress.update(static_cast<double>(k + 1) / static_cast<double>(moments.size()));
      return true;
    });
    return whole ? curve : FilmCurve{};
  }

  bool play(const std::vector<FilmMoment>& moments,
            const std::function<bool(std::size_t, const Draw&)>& show) override {
    if (!painter_) painter_.emplace(surface_, scene_);
    return run(moments, [&](std::size_t k, const CoatedMetal& metal) {
      return show(k, [&](const Camera& camera) { return painter_->draw(metal, camera); });
    });
  }

 private:
  static LoadedModel read(Scene& scene, Progress& progress) {
    progress.stage("reading");
    LoadedModel model = load_model(scene);
    progress.stage("building surface");
    return model;
  }

  bool run(const std::vector<FilmMoment>& moments,
           const std::function<bool(std::size_t, const CoatedMetal&)>& visit) {
    bool wanted = true;
    TimelineListener listener;
    for (const FilmMoment& moment : moments) listener.moments.push_back(moment.place);
    listener.progress = [&](std::size_t, double) { return wanted && !interrupted(); };
    listener.at = [&](std::size_t k, const CoatedMetal& metal) {
      if (wanted && !interrupted()) wanted = visit(k, metal);
    };
    CoatedMetal metal = make_coated_metal(surface_, material_);
    const glm::dvec3 up = scene_.picture.up == "z" ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    run_timeline(builtin_operators(), surface_, metal, scene_.weathering.timeline, masks_, up, scene_.seed,
                 listener);
    return wanted && !interrupted();
  }

  const Scene& scene_;
  Material material_;
  LoadedModel model_;
  Surface surface_;
  MaskBook masks_;
  std::optional<WeatherPainter> painter_;
};

// Steps to the last one. Whether it came there.
bool grow_to(AnySimulation& simulation, std::uint64_t last, Progress& progress) {
  progress.stage("growing");
  while (simulation.steps() < last) {
    simulation.step();
    progress.update(static_cast<double>(simulation.steps()) / static_cast<double>(last),
                    fmt::format("step {}", simulation.steps()));
    if (interrupted()) return false;
  }
  return true;
}

void no_lap(const char*) {}

// Corrosion of a material: once grown, any age can be drawn.
class CorrosionFilm final : public FilmSubject {
 public:
  CorrosionFilm(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet)
      : scene_(scene),
        material_(find_material(scene.corrosion.material)),
        run_(scene, behaviour, progress, quiet, no_lap),
        growth_(dynamic_cast<const CorrosionGrowth&>(*run_.simulation)),
        whole_(grow_to(*run_.simulation, scene.steps, progress)) {}

  bool whole() const { return whole_; }
  const Mesh& mesh() const override { return run_.surface.mesh(); }
  std::vector<double> years() const override {
    return {static_cast<double>(scene_.steps) * scene_.corrosion.step_years};
  }

  FilmCurve curve(const std::vector<FilmMoment>& moments, Progress&) override {
    const Field<std::int32_t> arrivals = growth_.field("arrival");
    std::vector<std::uint64_t> corroded(scene_.steps + 2, 0);  // [step + 1] cells by then
    for (const Row& row : run_.surface.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        if (arrivals[slot] >= 0) ++corroded[static_cast<std::size_t>(arrivals[slot]) + 1];
    for (std::size_t k = 1; k < corroded.size(); ++k) corroded[k] += corroded[k - 1];
    FilmCurve curve{{}, [](double value) { return fmt::format("{:.0f} % corroded", value); }};
    const auto cells = static_cast<double>(run_.surface.owned_count());
    for (const FilmMoment& moment : moments) {
      const auto step = static_cast<std::uint64_t>(moment.years / scene_.corrosion.step_years + 1e-9);
      const std::size_t then = std::min<std::uint64_t>(step, scene_.steps) + 1;
      curve.points.emplace_back(moment.years, 100.0 * static_cast<double>(corroded[then]) / cells);
    }
    return curve;
  }

  bool play(const std::vector<FilmMoment>& moments,
            const std::function<bool(std::size_t, const Draw&)>& show) override {
    if (!painter_) painter_.emplace(growth_, material_, scene_);
    for (std::size_t k = 0; k < moments.size(); ++k) {
      if (interrupted()) return false;
      if (!show(k, [&](const Camera& camera) { return painter_->draw(moments[k].years, camera); }))
        return false;
    }
    return true;
  }

 private:
  const Scene& scene_;
  Material material_;
  PreparedRun run_;
  const CorrosionGrowth& growth_;
  bool whole_;
  std::optional<PatinaPainter> painter_;
};

}  // namespace

void check_film_subject(Scene& scene) {
  if (scene.torus.width != 0)
    throw InputError(scene.file.string(), "a flat torus has no views to film", "name a model");
  if (!scene.picture.draw)
    throw InputError(scene.file.string(), "a film needs pictures, and the scene draws none",
                     "write draw = true under [picture], or remove it");
  check_picture(scene.picture);
  for (const CameraPlan& view : scene.animation.camera)
    view_direction(view.view, scene.picture.up == "z" ? UpAxis::z : UpAxis::y);
  if (!scene.weathering.empty()) {
    static_cast<void>(find_material(scene.weathering.material));
    return;
  }
  if (scene.corrosion.empty())
    throw InputError(scene.file.string(), "nothing in it ages in years",
                     "write [corrosion] with behaviour corrosion, or [weathering] with a [[timeline]]");
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  static_cast<void>(prepare_corrosion(scene));
  check_scene(scene, behaviour);
  complete_scene(scene, behaviour);
}

std::unique_ptr<FilmSubject> make_film_subject(Scene& scene, Progress& progress, bool quiet) {
  if (!scene.weathering.empty()) return std::make_unique<WeatheringFilm>(scene, progress, quiet);
  const Catalogue catalogue = builtin_catalogue();
  auto film = std::make_unique<CorrosionFilm>(scene, catalogue.find(scene.behaviour), progress, quiet);
  if (!film->whole()) return nullptr;
  return film;
}
