// A command for each behaviour of the catalogue, made of what the behaviour says of itself.

#include "behaviour_options.hpp"
#include "job.hpp"
#include "verdigris/behaviours/builtin.hpp"

using namespace verdigris;

namespace {

void add_behaviour(CLI::App& app, int& status, const BehaviourEntry& entry) {
  auto options = std::make_shared<BehaviourOptions>();
  auto* command = app.add_subcommand(entry.name, sentence(entry.summary));
  add_behaviour_options(*command, options, entry);
  command->footer("Writes cells.vtp, tables, picture.png, and run.toml, which repeats the run to the bit.");
  command->callback([options, entry, &status] {
    finish_behaviour_options(*options, entry);
    status = run_job(options->scene, options->run);
  });
}

}  // namespace

void add_behaviours(CLI::App& app, int& status) {
  const Catalogue catalogue = builtin_catalogue();
  for (const BehaviourEntry& entry : catalogue.entries()) add_behaviour(app, status, entry);
}
