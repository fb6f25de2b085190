#include <memory>

#include "job.hpp"
#include "weather_job.hpp"

void add_run(CLI::App& app, int& status) {
  struct Options {
    std::string scene;
    RunOptions run;
  };
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("run", "Run a scene file; repeats an earlier run to the bit from its run.toml");
  command->add_option("SCENE", options->scene, "Scene file (TOML)")->required();
  add_run_options(*command, options->run);
  command->footer(
      "A scene names mesh, surface, behaviour, seeds, barrier, run and picture; every run writes one as "
      "run.toml.\n"
      "Paths in it are relative to it.");
  command->callback([options, &status] {
    const verdigris::Scene scene = verdigris::read_scene(options->scene);
    status = scene.weathering.empty() ? run_job(scene, options->run) : run_weathering(scene, options->run);
  });
}
