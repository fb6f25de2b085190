#pragma once
// The main job: a scene in, cells, tables, picture and a scene that repeats it out.

#include <filesystem>

#include "options.hpp"
#include "verdigris/io/scene.hpp"

/// Runs `scene`, writes the results into options.out and reports on standard output. Returns the exit status:
/// 0, or 130 when the user stopped it (what was reached until then is written, and a checkpoint to go on
/// from). Throws InputError.
int run_job(verdigris::Scene scene, const RunOptions& options);
