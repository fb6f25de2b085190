#pragma once
// How a coat comes off its ground: a front of delamination that spreads where the energy it releases exceeds
// what the bond takes.

#include <cstdint>
#include <span>

#include "verdigris/automaton/behaviour.hpp"

namespace verdigris {

/// The rule. A bonded cell comes loose in a step when stress x open share > toughness: stress stands for the
/// energy release rate s^2 h / E of a film of thickness h (Hutchinson & Suo 1992, "Mixed mode cracking in
/// layered materials"), the open share for how far the front reaches around the cell, toughness for its bond.
/// A straight front opens 0.35 of a cell, so a stress below toughness / 0.35 comes to rest on such a front
/// and spreads only from notches. One chance in `every` a step makes fronts ragged.
struct DelaminationRule {
  using State = std::uint8_t;
  static constexpr State bonded = 0, loose = 1, bare = 2, outside_state = 3;
  static constexpr std::uint32_t purpose = 0x50454501;

  std::span<const float> stress;     ///< [slot]
  std::span<const float> toughness;  ///< [slot] > 0
  std::uint64_t chance = threshold(0.5);

  State outside() const { return outside_state; }
  bool settled(State s) const { return s != bonded; }
  static bool open(State s) { return s == loose || s == bare; }
  bool waits(const Neighbourhood<State>& n) const { return *n.here == bonded && open_share(n) > 0.0f; }

  /// Of the ring around a cell; corners weigh sqrt(1/2).
  static float open_share(const Neighbourhood<State>& n) {
    int sides = 0, corners = 0;
    for (int k = 0; k < 4; ++k) {
      sides += open(n.side(k));
      corners += open(n.corner(k));
    }
    return (static_cast<float>(sides) + 0.70710678f * static_cast<float>(corners)) / 6.8284271f;
  }

  State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    if (*n.here != bonded) return *n.here;
    const float share = open_share(n);
    if (share <= 0.0f || stress[random.cell()] * share <= toughness[random.cell()]) return bonded;
    return random.words(purpose)[0] < chance ? loose : bonded;
  }
};

}  // namespace verdigris
