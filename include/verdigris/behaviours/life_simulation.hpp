#pragma once
// Life-like behaviours by name: what rule, how it starts; packed bits for range 1, running sums beyond it.

#include <memory>
#include <string>

#include "verdigris/automaton/catalogue.hpp"

namespace verdigris {

/// Parameters of the behaviour `life`.
struct LifeParameters {
  std::string rule = "B3/S23";
  double density = 0.5;

  template <typename V>
  void parameters(V&& v) {
    v("rule", rule, {},
      "B3/S23, 23/3 (survival first), with V behind it for four neighbours; a name (life, highlife, "
      "coagulations, "
      "amoeba, day & night, maze, ...); or Larger-than-Life, R5,C0,M1,S34..58,B34..45,NM, range 1 to 10");
    v("density", density, 0.0, 1.0, "1",
      "share of cells alive at first, at random; seeds are alive beside them");
  }
};

/// The simulation. Cells start alive at random with parameters.density, or where the mask "alive" is at least
/// 0.5, and at the seeds. Its field is `alive`, 0 or 1. Ends when nothing changes. Throws InputError for a
/// rule that parse_life_rule and parse_range_rule refuse, for projected links and for barriers.
std::unique_ptr<AnySimulation> make_life(const SimulationSetup& setup, const LifeParameters& parameters);

/// The catalogue entry of Life-like behaviours.
BehaviourEntry life_entry();

}  // namespace verdigris
