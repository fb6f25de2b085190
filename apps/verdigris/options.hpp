#pragma once
// Command-line options that several commands share.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "verdigris/io/scene.hpp"

/// How a command talks and how many threads it uses.
struct RunOptions {
  std::string out = "verdigris-out";
  int threads = 0;               ///< 0: all cores
  std::string checkpoint_every;  ///< see parse_interval; empty: only when stopped
  bool no_cells = false;         ///< do not write cells.vtp
  bool resume = false;           ///< go on from the checkpoint in `out`
  bool json = false;
  bool quiet = false;
};

/// A count with an optional suffix: 250000, 1e6, 64k, 1M, 2.5G. Throws InputError naming `option`.
double parse_count(const std::string& text, const char* option);

/// WxH, as in 1280x960. Throws InputError.
void parse_size(const std::string& text, int& width, int& height);

/// WxH in cells, as in 4096x4096. Throws InputError.
void parse_torus(const std::string& text, int& width, int& height);

/// A check for numbers from `least` to `greatest`. CLI::Range takes what is no number for one in range.
CLI::Validator within(double least, double greatest);

/// A parameter's value for help texts: numbers to four digits.
std::string short_text(const verdigris::ParameterValue& value);

/// With a capital letter.
std::string sentence(std::string text);

/// --cells, --cell-size, --links, --mend. The text of --cells goes through parse_count in
/// `finish_surface_options`.
struct SurfaceOptionTexts {
  std::string cells, cell_size, links;
};
void add_surface_options(CLI::App& app, verdigris::Scene& scene, SurfaceOptionTexts& texts);
void finish_surface_options(verdigris::Scene& scene, const SurfaceOptionTexts& texts);

/// --view, --up, --size, --no-picture, --no-outline.
struct PictureOptionTexts {
  std::string size;
  bool no_picture = false, no_outline = false;
};
void add_picture_options(CLI::App& app, verdigris::Scene& scene, PictureOptionTexts& texts);
void finish_picture_options(verdigris::Scene& scene, const PictureOptionTexts& texts);

/// --mesh, --cells, --view, --up, --size: what takes the place of a scene file's own.
struct SceneOverrides {
  std::string mesh, cells, view, up, size;
};
void add_scene_overrides(CLI::App& app, SceneOverrides& overrides);
void apply(const SceneOverrides& overrides, verdigris::Scene& scene);

/// --out, --threads, --json, --quiet; for what can be taken up again --checkpoint-every and --resume.
void add_run_options(CLI::App& app, RunOptions& options, bool checkpoints = true);

/// The primitives of synthesis, for `list` and `synth --list`.
void print_primitives();

// The commands. Each registers itself and runs from its callback.
void add_animate(CLI::App& app, int& status);
void add_info(CLI::App& app);
void add_list(CLI::App& app);
void add_lsystem(CLI::App& app);
void add_run(CLI::App& app, int& status);
void add_synth(CLI::App& app);
void add_weather(CLI::App& app, int& status);
void add_behaviours(CLI::App& app, int& status);
void add_corrode(CLI::App& app, int& status);
void add_figures(CLI::App& app);
