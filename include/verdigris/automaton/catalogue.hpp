#pragma once
// The open catalogue: behaviours by name, each with parameters that describe themselves.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/automaton/simulation.hpp"
#include "verdigris/base/parameters.hpp"

namespace verdigris {

/// Where a region or spot starts, and how strong it is.
struct Seed {
  std::uint32_t slot;   ///< an owned cell
  double weight = 1.0;  ///< speed relative to other seeds, > 0
};

/// A scalar field that drives a behaviour: what it drives is its name.
struct Mask {
  std::string name;     ///< "strong", "seeding", ...: one of BehaviourEntry::masks
  Field<float> values;  ///< [slot], evolving cells count; 0 to 1
};

/// What a simulation starts from, beside its parameters.
struct SimulationSetup {
  const Surface& surface;            ///< must outlive the simulation
  std::uint64_t seed = 1;            ///< of the random numbers
  std::vector<Seed> seeds = {};      ///< for behaviours that grow from seeds
  Field<std::uint8_t> barrier = {};  ///< [slot] 1 where growth must not go; empty: nowhere
  std::vector<Mask> masks = {};      ///< for behaviours that take some, each name once

  /// The values of mask `name`; null when there is none.
  const Field<float>* mask(std::string_view name) const;
};

/// One behaviour of the catalogue.
struct BehaviourEntry {
  std::string name;
  std::string summary;       ///< one line
  bool needs_seeds = false;  ///< takes SimulationSetup::seeds
  std::vector<ParameterInfo> parameters;
  std::function<std::unique_ptr<AnySimulation>(const SimulationSetup&, const ParameterValues&)> create;
  std::vector<std::string> masks = {};  ///< names of the masks it takes
  bool on_projected = true;             ///< can run on projected links
  std::uint64_t default_steps = 0;      ///< where a run ends that may go on for ever; 0: it ends by itself
};

/// Behaviours by name. A value: whoever makes one may add to it, from outside the library too.
class Catalogue {
 public:
  /// Throws std::invalid_argument when the name is taken.
  void add(BehaviourEntry entry);

  /// Adds a self-describing behaviour: a Behaviour with `static constexpr const char *name, *summary`, with
  /// `State initial(const CellRandom&) const` and `template <typename V> void parameters(V&&)`.
  template <Behaviour B>
  void add() {
    BehaviourEntry entry;
    entry.name = B::name;
    entry.summary = B::summary;
    entry.parameters = describe_parameters<B>();
    entry.create = [](const SimulationSetup& setup,
                      const ParameterValues& values) -> std::unique_ptr<AnySimulation> {
      return std::make_unique<RuleSimulation<B>>(setup.surface, with_parameters<B>(B::name, values),
                                                 setup.seed);
    };
    // Only what rests or has a front comes to an end by itself.
    if constexpr (!RestingBehaviour<B> && !FrontBehaviour<B>) entry.default_steps = 100;
    add(std::move(entry));
  }

  /// Throws InputError naming the behaviours there are.
  const BehaviourEntry& find(std::string_view name) const;
  const std::vector<BehaviourEntry>& entries() const { return entries_; }

 private:
  std::vector<BehaviourEntry> entries_;
};

}  // namespace verdigris
