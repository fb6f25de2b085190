// Films of any behaviour, step by step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "film_subjects.hpp"
#include "picture.hpp"
#include "prepared_run.hpp"
#include "results.hpp"
#include "verdigris/surface/owned_cells.hpp"

using namespace verdigris;

namespace {

// Any other behaviour, step by step; made anew each time it is looked at.
class StepsFilm final : public FilmSubject {
 public:
  StepsFilm(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet)
      : scene_(scene), run_(scene, behaviour, progress, quiet), view_(run_.surface, scene.links) {
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
          each_owned(run_.surface, [&](std::uint32_t slot) { other += now[slot] != then[slot]; });
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

std::unique_ptr<FilmSubject> steps_film(Scene& scene, const BehaviourEntry& behaviour, Progress& progress,
                                        bool quiet) {
  auto film = std::make_unique<StepsFilm>(scene, behaviour, progress, quiet);
  if (!film->whole()) return nullptr;
  return film;
}
