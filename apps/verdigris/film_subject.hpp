#pragma once
// What a film can be made of: something that changes in time and can be drawn at any moment of it.

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "progress.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/picture/camera.hpp"
#include "verdigris/picture/film_schedule.hpp"
#include "verdigris/picture/image.hpp"

/// What there is at a moment.
struct FilmState {
  std::function<verdigris::Image(const verdigris::Camera&)> draw;
  std::function<double()> value;  ///< of the curve
};
using ShowState = std::function<bool(std::size_t moment, const FilmState& state)>;

/// A curve beside the clock of a film.
struct FilmCurve {
  std::vector<glm::dvec2> points;                  ///< [moment] years, value
  std::function<std::string(double value)> words;  ///< "35 % corroded"
};

/// One run that is filmed: where its time goes, and how it looks on the way.
class FilmSubject {
 public:
  virtual ~FilmSubject() = default;
  /// Seconds spent growing before the first frame.
  double grown() const { return grown_; }
  virtual const verdigris::Mesh& mesh() const = 0;
  /// [operation] years that each takes; behaviours without years take steps.
  virtual std::vector<double> years() const = 0;
  /// What to call so many of them in a film of so many in all.
  virtual std::string time_text(double years, double total) const;
  /// Values at the moments. May simulate all of it once. Empty when the user stopped it.
  virtual FilmCurve curve(const std::vector<verdigris::FilmMoment>& moments, Progress& progress) = 0;
  /// Shows the moments in order until `show` says false, or the user stops it; then it returns false.
  virtual bool play(const std::vector<verdigris::FilmMoment>& moments, const ShowState& show) = 0;

 protected:
  double grown_ = 0.0;
};

/// The scene's timeline, or its corrosion, or any other behaviour step by step. Reads the model, lays cells,
/// and grows what must be grown before the first frame; completes the scene as a run does. The scene must
/// outlive it. Null when the user stopped it. Throws InputError.
std::unique_ptr<FilmSubject> make_film_subject(verdigris::Scene& scene, Progress& progress, bool quiet);

/// Refuses what can be known before the model is read, and completes the scene as a run does. Throws
/// InputError.
void prepare_film(verdigris::Scene& scene);

/// The moments of a plan in operations of so many years. Throws InputError.
std::vector<verdigris::FilmMoment> film_moments_of(const verdigris::AnimationPlan& plan,
                                                   const std::vector<double>& years);
