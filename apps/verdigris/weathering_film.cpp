// Films of timelines.
#include <fmt/format.h>

#include <optional>

#include "film_subjects.hpp"
#include "prepared_timeline.hpp"
#include "weather_pictures.hpp"

using namespace verdigris;

namespace {

// A timeline, made anew each time it is looked at.
class WeatheringFilm final : public FilmSubject {
 public:
  WeatheringFilm(Scene& scene, Progress& progress, bool quiet)
      : scene_(scene), timeline_(scene, progress, quiet) {}

  const Mesh& mesh() const override { return timeline_.surface().mesh(); }
  std::vector<double> years() const override {
    return timeline_years(builtin_operators(), scene_.weathering.timeline);
  }

  FilmCurve curve(const std::vector<FilmMoment>& moments, Progress& progress) override {
    progress.stage("rehearsing");
    FilmCurve curve{{}, [](double value) { return fmt::format("{:.3g} µm of metal lost", value); }};
    const bool whole = run(moments, [&](std::size_t k, const CoatedMetal& metal) {
      curve.points.emplace_back(moments[k].years, loss(metal));
      progress.update(static_cast<double>(k + 1) / static_cast<double>(moments.size()));
      return true;
    });
    return whole ? curve : FilmCurve{};
  }

  bool play(const std::vector<FilmMoment>& moments, const ShowState& show) override {
    if (!painter_) painter_.emplace(timeline_.surface(), scene_);
    return run(moments, [&](std::size_t k, const CoatedMetal& metal) {
      return show(k, {[&](const Camera& camera) { return painter_->draw(metal, camera); },
                      [&] { return loss(metal); }});
    });
  }

 private:
  double loss(const CoatedMetal& metal) const { return measure(timeline_.surface(), metal).loss; }

  bool run(const std::vector<FilmMoment>& moments,
           const std::function<bool(std::size_t, const CoatedMetal&)>& visit) {
    bool wanted = true;
    TimelineListener listener;
    for (const FilmMoment& moment : moments) listener.moments.push_back(moment.place);
    listener.progress = [&](std::size_t, double) { return wanted && !interrupted(); };
    listener.at = [&](std::size_t k, const CoatedMetal& metal) {
      if (wanted && !interrupted()) wanted = visit(k, metal);
    };
    CoatedMetal metal = timeline_.metal();
    timeline_.run(metal, listener);
    return wanted && !interrupted();
  }

  const Scene& scene_;
  PreparedTimeline timeline_;
  std::optional<WeatherPainter> painter_;
};

}  // namespace

std::unique_ptr<FilmSubject> weathering_film(Scene& scene, Progress& progress, bool quiet) {
  return std::make_unique<WeatheringFilm>(scene, progress, quiet);
}
