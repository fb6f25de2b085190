#include "animation_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <optional>

#include "film.hpp"
#include "film_subject.hpp"
#include "model.hpp"
#include "picture.hpp"
#include "result_place.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/write_video.hpp"
#include "verdigris/picture/camera_path.hpp"
#include "verdigris/picture/overlay.hpp"

using namespace verdigris;

namespace {

using Clock = std::chrono::steady_clock;

// Where the time of a film goes.
struct Seconds {
  double prepare = 0.0, simulate = 0.0, draw = 0.0, encode = 0.0;
  double total() const { return prepare + simulate + draw + encode; }
};

double since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

CameraPath path_of(const Scene& scene, const Mesh& mesh) {
  const ViewSettings settings = view_settings(scene.picture);
  std::vector<CameraKey> keys;
  for (const CameraPlan& view : scene.animation.camera)
    keys.push_back({view.at, view_direction(view.view, settings.up), view.zoom, view.target});
  if (keys.empty()) keys.push_back({0.0, view_direction(scene.picture.view, settings.up), 1.0, {}});
  return {mesh, std::move(keys), scene.animation.turn, settings};
}

// As many moments as a small plot needs, the last among them.
std::vector<FilmMoment> sparse(const std::vector<FilmMoment>& moments) {
  constexpr std::size_t enough = 40;
  const std::size_t stride = std::max<std::size_t>(1, moments.size() / enough);
  std::vector<FilmMoment> some;
  for (std::size_t k = 0; k < moments.size(); k += stride) some.push_back(moments[k]);
  if (some.back() != moments.back()) some.push_back(moments.back());
  return some;
}

// Draws the frames that are not there. What is the same twice is drawn once.
class Filming {
 public:
  Filming(const Scene& scene, FilmSubject& subject, const std::vector<FilmMoment>& moments, Film& film,
          Progress& progress)
      : scene_(scene),
        subject_(subject),
        moments_(moments),
        film_(film),
        progress_(progress),
        path_(path_of(scene, subject.mesh())) {}

  /// False when the user stopped it.
  bool shoot() {
    const bool overlay = scene_.animation.overlay;
    if (overlay) {
      const auto begin = Clock::now();
      curve_ = subject_.curve(sparse(moments_), progress_);
      simulating_ += since(begin);
      if (curve_.points.empty()) return false;
    }
    progress_.stage("drawing frames");
    const auto begin = Clock::now();
    const bool whole = subject_.play(moments_, [&](std::size_t k, const FilmState& state) {
      if (film_.has(k) && k != film_.to_check()) return true;
      const auto drawn = Clock::now();
      frame(k, state);
      drawing_ += since(drawn);
      return !interrupted();
    });
    film_.finish();
    simulating_ += since(begin) - drawing_;
    return whole;
  }

  std::size_t drawn() const { return drawn_; }
  double drawing() const { return drawing_; }
  double simulating() const { return simulating_; }

 private:
  void frame(std::size_t k, const FilmState& state) {
    const auto count = static_cast<double>(moments_.size());
    if (path_.moves() || !latest_ || moments_[k] != moments_[*latest_])
      image_ = state.draw(path_.at(count > 1 ? static_cast<double>(k) / (count - 1) : 0.0));
    latest_ = k;
    Image image = image_;
    if (scene_.animation.overlay) {
      const FilmMoment& moment = moments_[k];
      draw_overlay(image, {subject_.time_text(moment.years, moments_.back().years),
                           curve_.words(state.value()), curve_.points, moment.years});
    }
    if (k == film_.to_check()) {
      film_.check(k, image);
      return;
    }
    film_.add(k, std::move(image));
    ++drawn_;
    progress_.update(static_cast<double>(drawn_) / static_cast<double>(moments_.size() - film_.kept()),
                     fmt::format("frame {} of {}", k + 1, moments_.size()));
  }

  const Scene& scene_;
  FilmSubject& subject_;
  const std::vector<FilmMoment>& moments_;
  Film& film_;
  Progress& progress_;
  CameraPath path_;
  FilmCurve curve_;
  Image image_;                        // of frame latest_
  std::optional<std::size_t> latest_;  // that was drawn
  std::size_t drawn_ = 0;
  double drawing_ = 0.0, simulating_ = 0.0;
};

void report(const Scene& scene, const FilmOptions& options, const Film& film, std::size_t frames,
            std::size_t drawn, const Seconds& seconds, bool complete) {
  const char* const video = complete && options.video ? "animation.mp4" : nullptr;
  if (options.json) {
    nlohmann::ordered_json all{{"model", model_name(scene)},
                               {"cell_size", scene.cell_size},
                               {"frames", frames},
                               {"drawn", drawn},
                               {"complete", complete},
                               {"seconds",
                                {{"prepare", seconds.prepare},
                                 {"simulate", seconds.simulate},
                                 {"draw", seconds.draw},
                                 {"encode", seconds.encode},
                                 {"total", seconds.total()}}},
                               {"out", options.out}};
    all["video"] = video != nullptr ? nlohmann::ordered_json(video) : nlohmann::ordered_json();
    fmt::print("{}\n", all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!options.quiet) {
    fmt::print("{}: {} frames, {} of them drawn now, in {}\n", model_name(scene), frames, drawn,
               film.directory().string());
    fmt::print("{:.1f} s: {:.1f} reading and building, {:.1f} simulating, {:.1f} drawing, {:.1f} encoding\n",
               seconds.total(), seconds.prepare, seconds.simulate, seconds.draw, seconds.encode);
    if (video != nullptr) fmt::print("{}/{}\n", options.out, video);
  }
}

}  // namespace

int run_animation(Scene scene, const FilmOptions& options) {
  const ThreadLimit threads(options.threads);
  const std::string ffmpeg = options.video ? find_ffmpeg() : "";
  prepare_film(scene);
  check_inputs(scene, options.out);
  Progress progress(!options.quiet);
  watch_for_interrupt();
  Seconds seconds;
  const ResultPlace place(options.out);
  auto begin = Clock::now();
  const auto subject = make_film_subject(scene, progress, options.quiet);
  if (subject == nullptr) {
    say("stopped before the first frame; nothing is written\n");
    return 130;
  }
  const std::vector<FilmMoment> moments = film_moments_of(scene.animation, subject->years());
  if (!options.resume) place.clear();
  Film film(options.out, scene, moments.size(), options.resume);
  Filming filming(scene, *subject, moments, film, progress);
  seconds.prepare = since(begin) - subject->grown();
  bool complete = filming.shoot();
  seconds.simulate = filming.simulating() + subject->grown();
  seconds.draw = filming.drawing();
  if (complete && options.video) {
    progress.stage("encoding");
    begin = Clock::now();
    complete = write_video(ffmpeg, film.files(), scene.animation.rate,
                           std::filesystem::path(options.out) / "animation.mp4", [&](std::size_t done) {
                             progress.update(static_cast<double>(done) / static_cast<double>(moments.size()));
                             return !interrupted();
                           });
    seconds.encode = since(begin);
  }
  progress.finish();
  if (!complete)
    say("stopped; {} of {} frames are there; the same command with --resume goes on from there\n",
        film.kept() + filming.drawn(), moments.size());
  report(scene, options, film, moments.size(), filming.drawn(), seconds, complete);
  return complete ? 0 : 130;
}
