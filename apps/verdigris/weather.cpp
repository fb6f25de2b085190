// verdigris weather: what happens to a coated metal, from a scene with a timeline.

#include <memory>

#include "verdigris/base/error.hpp"
#include "weather_job.hpp"

using namespace verdigris;

void add_weather(CLI::App& app, int& status) {
  struct Options {
    std::string scene, mesh, cells, size, view, up;
    bool no_picture = false;
    RunOptions run;
  };
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("weather", "Coat, age, crack, peel, polish: run the timeline of a scene");
  command->add_option("SCENE", options->scene, "Scene file (TOML) with [weathering] and [[timeline]]")
      ->required();
  command->add_option("--mesh", options->mesh, "Another model than the scene's")->type_name("MODEL");
  command->add_option("--cells", options->cells, "Another number of cells: 250000, 500k, 2M")->type_name("N");
  command->add_option("--view", options->view, "Another view: front, iso, or a direction x,y,z")
      ->type_name("VIEW");
  command->add_option("--up", options->up, "Axis of the model that points up: y or z")
      ->type_name("AXIS")
      ->check(CLI::IsMember({"y", "z"}));
  command->add_option("--size", options->size, "Another picture size in pixels")->type_name("WxH");
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
    if (!options->mesh.empty()) {
      scene.mesh = options->mesh;
      scene.mesh_hash.clear();
    }
    if (!options->cells.empty()) {
      scene.cells = parse_count(options->cells, "--cells");
      scene.cell_size = 0.0;
    }
    if (!options->view.empty()) scene.picture.view = options->view;
    if (!options->up.empty()) scene.picture.up = options->up;
    if (!options->size.empty()) parse_size(options->size, scene.picture.width, scene.picture.height);
    if (options->no_picture) scene.picture.draw = false;
    status = run_weathering(scene, options->run);
  });
}
