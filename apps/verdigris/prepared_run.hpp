#pragma once
// A run before its first step: everything a scene asks for, read, laid, placed and made.

#include <functional>
#include <memory>

#include "model.hpp"
#include "progress.hpp"
#include "start.hpp"
#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/io/scene.hpp"

/// Refuses what can be known to be wrong before the model is read. Throws InputError.
void check_scene(const verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour);

/// Gives the scene every parameter of its behaviour, in the behaviour's order, and its steps: what run.toml
/// holds and repeats.
void complete_scene(verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour);

/// Stays where it is made: its parts refer to each other.
class PreparedRun {
 public:
  /// `scene` gets the hash of the model, the size of cells that was used and, where it has a material, the
  /// unit. `lap` hears of each stage done: read, build, place_seeds. Throws InputError.
  PreparedRun(
      verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour, Progress& progress, bool quiet,
      const std::function<void(const char* stage)>& lap = [](const char*) {});
  PreparedRun(const PreparedRun&) = delete;
  PreparedRun& operator=(const PreparedRun&) = delete;

  LoadedModel model;  ///< without its mesh, which is the surface's
  verdigris::Surface surface;
  double coverage;
  PlacedSeeds placed;
  verdigris::SimulationSetup setup;
  std::unique_ptr<verdigris::AnySimulation> simulation;
};
