// verdigris weather: what happens to a coated metal, from a scene with a timeline.

#include <memory>

#include "verdigris/base/error.hpp"
#include "weather_job.hpp"

using namespace verdigris;

void add_weather(CLI::App& app, int& status) {
  struct Options {
    std::string scene;
    SceneOverrides overrides;
    bool no_picture = false;
    RunOptions run;
  };
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("weather", "Coat, age, crack, peel, polish: run the timeline of a scene");
  command->add_option("SCENE", options->scene, "Scene file (TOML) with [weathering] and [[timeline]]")
      ->required();
  add_scene_overrides(*command, options->overrides);
  command->add_flag("--no-picture", options->no_picture, "Write data only; needs no OpenGL");
  add_run_options(*command, options->run, false);
  command->footer(
      "Writes a picture after each operation, picture.png, cells.vtp, timeline.csv, and run.toml, which\n"
      "repeats the run. `verdigris list` names the operators; docs/weathering.md says what they do.");
  command->callback([options, &status] {
    Scene scene = read_scene(options->scene);
    if (scene.weathering.empty())
      throw InputError(options->scene, "it has no [weathering]",
                       "write one, with a [[timeline]], or use `verdigris run`");
    apply(options->overrides, scene);
    if (options->no_picture) scene.picture.draw = false;
    status = run_weathering(scene, options->run);
  });
}
