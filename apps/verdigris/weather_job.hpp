#pragma once
// A scene with a timeline, from end to end.

#include "options.hpp"
#include "verdigris/io/scene.hpp"

/// Runs `scene`, whose weathering is not empty; writes into options.out cells.vtp, timeline.csv, a picture
/// after each operation (NN-OP.png), picture.png, and run.toml, which repeats it. Returns the exit status: 0,
/// or 130 when the user stopped it (what was done until then is written). Throws InputError.
int run_weathering(verdigris::Scene scene, const RunOptions& options);
