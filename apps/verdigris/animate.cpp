// verdigris animate: a film of what a scene does.

#include <algorithm>
#include <memory>

#include "animation_job.hpp"
#include "options.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

void add_animate(CLI::App& app, int& status) {
  struct Options {
    std::string scene;
    SceneOverrides overrides;
    std::vector<double> years;
    std::uint64_t frames = 0, hold = 0;
    double rate = 0.0, turn = 0.0;
    bool overlay = false, no_video = false;
    FilmOptions film;
  };
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("animate", "Film what a scene does in time, as PNGs and MP4");
  command
      ->add_option("SCENE", options->scene,
                   "Scene file (TOML): a timeline, a corrosion, or any behaviour (a run's run.toml too)")
      ->required();
  auto* frames =
      command->add_option("--frames", options->frames, "Frames, spread over the run (default: 120)")
          ->type_name("N")
          ->check(CLI::Range(1, 100000));
  auto* years =
      command
          ->add_option("--years", options->years,
                       "Chosen times instead, a frame each: 0,1,5,30; steps where nothing takes years")
          ->type_name("Y,...")
          ->delimiter(',')
          ->excludes(frames);
  auto* hold =
      command
          ->add_option("--hold", options->hold,
                       "Frames that a still stands: beginning, end, and each operation that takes no "
                       "time (default: 12)")
          ->type_name("N")
          ->check(CLI::Range(0, 10000));
  auto* rate = command->add_option("--rate", options->rate, "Frames a second (default: 24)")
                   ->type_name("FPS")
                   ->check(within(1.0, 240.0));
  auto* turn =
      command->add_option("--turn", options->turn, "How far the camera goes round the model (default: 0)")
          ->type_name("DEG")
          ->check(within(-36000.0, 36000.0));
  command->add_flag("--overlay", options->overlay, "Write the time and a curve over the frames");
  add_scene_overrides(*command, options->overrides);
  command->add_option("--out,-o", options->film.out, "Directory for the film; made if need be")
      ->type_name("DIR")
      ->capture_default_str();
  add_thread_option(*command, options->film.threads);
  command->add_flag("--resume", options->film.resume,
                    "Go on with a film that was stopped: frames that are there are kept");
  command->add_flag("--no-video", options->no_video, "Draw the frames only; needs no ffmpeg");
  command->add_flag("--json", options->film.json, "Report as one JSON object on standard output");
  command->add_flag("--quiet,-q", options->film.quiet, "No progress and no report");
  command->footer(
      "Writes frames/00000.png ..., animation.mp4, and run.toml, which makes the same film again.\n"
      "[animation] in a scene holds the same, and a path of the camera; docs/films.md says how.");
  command->callback([=, &status] {
    Scene scene = read_scene(options->scene);
    AnimationPlan& film = scene.animation;
    if (frames->count() > 0) film.frames = options->frames, film.years.clear();
    if (years->count() > 0) {
      film.years = options->years;
      if (!std::is_sorted(film.years.begin(), film.years.end()) || !(film.years.front() >= 0.0))
        throw InputError("--years", "they are not ascending", "sort them; the first is 0 or more");
    }
    if (hold->count() > 0) film.hold = options->hold;
    if (rate->count() > 0) film.rate = options->rate;
    if (turn->count() > 0) film.turn = options->turn;
    if (options->overlay) film.overlay = true;
    apply(options->overrides, scene);
    options->film.video = !options->no_video;
    status = run_animation(std::move(scene), options->film);
  });
}
