#include "film_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "corrosion_pictures.hpp"
#include "corrosion_results.hpp"
#include "masks.hpp"
#include "picture.hpp"
#include "prepared_run.hpp"
#include "results.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/io/read_material.hpp"
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
        masks_(surface_, all_masks(surface_, scene, model_.read), scene.picture.up, scene.seed) {
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

  bool play(const std::vector<FilmMoment>& moments, const ShowState& show) override {
    if (!painter_) painter_.emplace(surface_, scene_);
    return run(moments, [&](std::size_t k, const CoatedMetal& metal) {
      return show(k, {[&](const Camera& camera) { return painter_->draw(metal, camera); },
                      [&] { return measure(surface_, metal).loss; }});
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

// Steps to the last one, 0: until nothing changes. Whether it came there; the time it took is added.
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

void no_lap(const char*) {}

// Corrosion of a material: once grown, any age can be drawn.
class CorrosionFilm final : public FilmSubject {
 public:
  CorrosionFilm(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet)
      : scene_(scene),
        material_(find_material(scene.corrosion.material)),
        run_(scene, behaviour, progress, quiet, no_lap),
        growth_(dynamic_cast<const CorrosionGrowth&>(*run_.simulation)),
        whole_(grow_to(*run_.simulation, scene.steps, progress, grown_)) {}

  bool whole() const { return whole_; }
  const Mesh& mesh() const override { return run_.surface.mesh(); }
  std::vector<double> years() const override {
    return {static_cast<double>(scene_.steps) * scene_.corrosion.step_years};
  }

  FilmCurve curve(const std::vector<FilmMoment>& moments, Progress&) override {
    FilmCurve curve{{}, [](double value) { return fmt::format("{:.0f} % corroded", value); }};
    for (const FilmMoment& moment : moments) curve.points.emplace_back(moment.years, corroded(moment.years));
    return curve;
  }

  bool play(const std::vector<FilmMoment>& moments, const ShowState& show) override {
    if (!painter_) painter_.emplace(growth_, material_, scene_);
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const double years = moments[k].years;
      const FilmState state{[&](const Camera& camera) { return painter_->draw(years, camera); },
                            [&] { return corroded(years); }};
      if (interrupted() || !show(k, state)) return false;
    }
    return true;
  }

 private:
  // Percent of the cells, after so many years.
  double corroded(double years) {
    if (by_step_.empty()) {
      const Field<std::int32_t> arrivals = growth_.field("arrival");
      by_step_.assign(scene_.steps + 2, 0);
      for (const Row& row : run_.surface.rows())
        for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
          if (arrivals[slot] >= 0) ++by_step_[static_cast<std::size_t>(arrivals[slot]) + 1];
      for (std::size_t k = 1; k < by_step_.size(); ++k) by_step_[k] += by_step_[k - 1];
    }
    const auto step = static_cast<std::uint64_t>(years / scene_.corrosion.step_years + 1e-9);
    return 100.0 * static_cast<double>(by_step_[std::min<std::uint64_t>(step, scene_.steps) + 1]) /
           static_cast<double>(run_.surface.owned_count());
  }

  const Scene& scene_;
  Material material_;
  PreparedRun run_;
  const CorrosionGrowth& growth_;
  bool whole_;
  std::vector<std::uint64_t> by_step_;  // [step + 1] cells corroded by then
  std::optional<PatinaPainter> painter_;
};

// Any other behaviour, step by step; made anew each time it is looked at.
class StepsFilm final : public FilmSubject {
 public:
  StepsFilm(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet)
      : scene_(scene), run_(scene, behaviour, progress, quiet, no_lap), view_(run_.surface, scene.links) {
    restart_ = [&scene, &behaviour, this] { return behaviour.create(run_.setup, scene.parameters); };
    AnySimulation& simulation = *run_.simulation;
    const bool labels = simulation.fields().front().kind == FieldKind::label;
    if (scene.steps == 0 || labels) {
      // Where it ends of itself, and which regions come to touch, nobody knows before.
      whole_ = grow_to(simulation, scene.steps, progress, grown_);
      scene.steps = simulation.steps();
      colours_ = colours_for(view_.surface(), view_(first_field(simulation)), labels);
    }
    run_.simulation.reset();
  }

  bool whole() const { return whole_; }
  const Mesh& mesh() const override { return run_.surface.mesh(); }
  std::vector<double> years() const override { return {static_cast<double>(scene_.steps)}; }
  std::string time_text(double years, double) const override {
    return fmt::format("step {:.0f}", std::floor(years));
  }

  FilmCurve curve(const std::vector<FilmMoment>& moments, Progress& progress) override {
    progress.stage("rehearsing");
    FilmCurve curve{{}, [](double value) { return fmt::format("{:.1f} % changed", value); }};
    const bool whole = run(moments, [&](std::size_t k, const AnySimulation& simulation) {
      curve.points.emplace_back(moments[k].years, changed(simulation));
      progress.update(static_cast<double>(k + 1) / static_cast<double>(moments.size()));
      return true;
    });
    return whole ? curve : FilmCurve{};
  }

  bool play(const std::vector<FilmMoment>& moments, const ShowState& show) override {
    if (!painter_) painter_.emplace(view_.surface(), scene_.picture.outline);
    return run(moments, [&](std::size_t k, const AnySimulation& simulation) {
      const CellValues values = view_(first_field(simulation));
      if (colours_.regions.empty()) {
        // One scale from frame to frame; it only grows.
        const CellColours now = colours_for(run_.surface, values, false);
        colours_.low = std::min(colours_.low, now.low);
        colours_.high = std::max(colours_.high, now.high);
      }
      return show(k, {[&](const Camera& camera) { return painter_->draw(values, colours_, camera); },
                      [&] { return changed(simulation); }});
    });
  }

 private:
  // Percent of the cells that are not as in the beginning.
  double changed(const AnySimulation& simulation) {
    if (!first_) first_ = first_field(*restart_());
    std::uint64_t other = 0;
    std::visit(
        [&](const auto& now) {
          const auto& then = std::get<std::decay_t<decltype(now)>>(*first_);
          for (const Row& row : run_.surface.rows())
            for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
              other += now[slot] != then[slot];
        },
        first_field(simulation));
    return 100.0 * static_cast<double>(other) / static_cast<double>(run_.surface.owned_count());
  }

  bool run(const std::vector<FilmMoment>& moments,
           const std::function<bool(std::size_t, const AnySimulation&)>& visit) {
    const std::unique_ptr<AnySimulation> simulation = restart_();
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const auto last = static_cast<std::uint64_t>(moments[k].years + 1e-9);
      while (simulation->steps() < last && !simulation->finished() && !interrupted()) simulation->step();
      if (interrupted() || !visit(k, *simulation)) return false;
    }
    return true;
  }

  const Scene& scene_;
  PreparedRun run_;
  OpenView view_;
  std::function<std::unique_ptr<AnySimulation>()> restart_;
  bool whole_ = true;
  CellColours colours_;
  std::optional<CellValues> first_;
  std::optional<CellPainter> painter_;
};

}  // namespace

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
  for (const CameraPlan& view : scene.animation.camera)
    view_direction(view.view, scene.picture.up == "z" ? UpAxis::z : UpAxis::y);
  if (!scene.weathering.empty()) {
    static_cast<void>(find_material(scene.weathering.material));
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
  if (!scene.weathering.empty()) return std::make_unique<WeatheringFilm>(scene, progress, quiet);
  static const Catalogue catalogue = builtin_catalogue();  // outlives the film, which makes runs anew
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  const auto if_whole = [](auto film) -> std::unique_ptr<FilmSubject> {
    if (!film->whole()) return nullptr;
    return film;
  };
  if (!scene.corrosion.empty())
    return if_whole(std::make_unique<CorrosionFilm>(scene, behaviour, progress, quiet));
  return if_whole(std::make_unique<StepsFilm>(scene, behaviour, progress, quiet));
}
