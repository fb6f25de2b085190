// Films of corrosion that ages in years.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>

#include "corrosion_pictures.hpp"
#include "film_subjects.hpp"
#include "prepared_run.hpp"
#include "verdigris/io/read_material.hpp"

using namespace verdigris;

namespace {

// Corrosion of a material: once grown, any age can be drawn.
class CorrosionFilm final : public FilmSubject {
 public:
  CorrosionFilm(Scene& scene, const BehaviourEntry& behaviour, Progress& progress, bool quiet)
      : scene_(scene),
        material_(find_material(scene.corrosion.material)),
        run_(scene, behaviour, progress, quiet),
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
  double corroded(double years) const {
    const auto step = static_cast<std::ptrdiff_t>(years / scene_.corrosion.step_years + 1e-9);
    const auto& births = growth_.births();
    const auto end = births.begin() + std::min(step + 1, static_cast<std::ptrdiff_t>(births.size()));
    return 100.0 * static_cast<double>(std::accumulate(births.begin(), end, std::uint64_t{0})) /
           static_cast<double>(run_.surface.owned_count());
  }

  const Scene& scene_;
  Material material_;
  PreparedRun run_;
  const CorrosionGrowth& growth_;
  bool whole_;
  std::optional<PatinaPainter> painter_;
};

}  // namespace

std::unique_ptr<FilmSubject> corrosion_film(Scene& scene, const BehaviourEntry& behaviour, Progress& progress,
                                            bool quiet) {
  auto film = std::make_unique<CorrosionFilm>(scene, behaviour, progress, quiet);
  if (!film->whole()) return nullptr;
  return film;
}
