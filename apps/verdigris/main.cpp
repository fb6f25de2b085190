// verdigris: cellular automata on the surface of any triangle mesh, from the command line.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "options.hpp"
#include "progress.hpp"

namespace {
constexpr int bad_input = 2;
}

int main(int argc, char** argv) {
  CLI::App app{
      "Cellular automata on the surface of any triangle mesh.\n"
      "Every triangle is laid on its own grid of square cells; behaviours grow over the model across its "
      "edges.",
      "verdigris"};
  app.set_version_flag("--version", "verdigris " VERDIGRIS_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Examples:\n"
      "  verdigris info bunny.obj\n"
      "  verdigris voronoi bunny.obj --seeds 64 --cells 1M --out bunny-regions\n"
      "  verdigris run bunny-regions/run.toml --out again\n\n"
      "Exit status: 0 done, 2 bad input or options, 130 stopped by Ctrl-C or SIGTERM with results so far\n"
      "and a checkpoint for --resume written.");
  app.get_formatter()->column_width(30);
  // Misuse is said as all bad input is; the help of the command that was meant is the remedy.
  app.failure_message([](const CLI::App* root, const CLI::Error& error) {
    const auto commands = root->get_subcommands();
    return fmt::format("error: {}\n  remedy: see verdigris {}--help\n", error.what(),
                       commands.empty() ? "" : commands.front()->get_name() + " ");
  });
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is an error like others
  int status = 0;
  add_info(app);
  add_behaviours(app, status);
  add_corrode(app, status);
#ifdef VERDIGRIS_WITH_GL
  add_figures(app);
#endif
  add_run(app, status);
  add_synth(app);
  add_weather(app, status);
  add_animate(app, status);
  add_lsystem(app);
  add_list(app);

  try {
    for (int k = 1; k < argc; ++k)
      if (argv[k][0] == '\0') {
        say("error: argument {} is empty\n  remedy: give the option a value, or leave it out\n", k);
        return bad_input;
      }
    const auto is_first = [&](const CLI::App* command) { return command->get_name() == argv[1]; };
    if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(is_first).empty()) {
      std::vector<std::string> names;
      for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
      say("error: there is no command '{}'\n  remedy: choose one of {}\n", argv[1], fmt::join(names, ", "));
      return bad_input;
    }
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    // Help and version leave with 0, every misuse with the status of bad input.
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const std::bad_alloc&) {
    say("error: out of memory\n  remedy: use fewer cells (--cells) or a machine with more memory\n");
    return bad_input;
  } catch (const std::exception& error) {
    say("error: {}\n", error.what());
    return bad_input;
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    say("error: standard output: could not be written\n  remedy: see where it is directed to\n");
    return bad_input;
  }
  return status;
}
