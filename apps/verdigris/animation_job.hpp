#pragma once
// A film of a scene, from end to end.

#include <string>

#include "verdigris/io/scene.hpp"

/// How a film is made, beside what the scene says.
struct FilmOptions {
  std::string out = "verdigris-film";
  int threads = 0;      ///< 0: all cores
  bool video = true;    ///< encode the frames
  bool resume = false;  ///< go on with the frames in `out`
  bool json = false, quiet = false;
};

/// Draws the frames of `scene` into out/frames, writes out/animation.mp4 and out/run.toml, and reports on
/// standard output. Returns the exit status: 0, or 130 when the user stopped it (the frames drawn until then
/// stay). Throws InputError.
int run_animation(verdigris::Scene scene, const FilmOptions& options);
