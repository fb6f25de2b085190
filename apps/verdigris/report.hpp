#pragma once
// What a run says of itself when it is done.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "results.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/mesh/mend.hpp"

/// Everything a report tells. Seconds by stage: read, build, place_seeds, start, grow, checkpoints (within
/// grow), write, picture, total.
struct RunReport {
  const verdigris::Scene& scene;
  const verdigris::Surface& surface;
  const verdigris::AnySimulation& simulation;
  verdigris::MendReport mended;
  Results results;
  nlohmann::ordered_json seconds;
  std::string out;
  std::size_t seeds = 0;
  std::uint64_t first_step = 0, updates = 0;
  double coverage = 1.0;
  bool complete = true;
  bool sweeps = false;  ///< a behaviour that goes on for ever: updates are what counts
};

/// As one JSON object, or in words, on standard output.
void print_json(const RunReport& report);
void print_words(const RunReport& report);
