#pragma once
// A run that can be taken up again: where it stands, and what it is a run of.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/automaton/saved_state.hpp"

namespace verdigris {

/// What a run depends on, as pairs of what it is and its value, in plain words: {"cell size", "0.01"}. Two
/// runs of equal identity make the same steps to the bit. Large things stand in it by their hash.
using RunIdentity = std::vector<std::pair<std::string, std::string>>;

/// A run at the end of a step.
struct Checkpoint {
  RunIdentity identity;
  SavedState state;
};

/// The identity of behaviour.create(setup, values): mesh, cells and how they are joined, behaviour and every
/// parameter, seed, seeds and barrier.
RunIdentity identity_of(const BehaviourEntry& behaviour, const SimulationSetup& setup,
                        const ParameterValues& values);

/// Throws InputError about `where`, naming the first thing in which `now` differs from `saved`.
void check_identity(const std::string& where, const RunIdentity& saved, const RunIdentity& now);

}  // namespace verdigris
