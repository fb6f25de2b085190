#pragma once
// Life-like behaviours: two states, birth and survival by the number of live neighbours.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"

namespace verdigris {

/// Which cells around a cell are counted.
enum class LifeNeighbourhood : std::uint8_t { moore, von_neumann };

/// A rule of range 1: bit n of `birth` and `survival` says what n live neighbours do.
struct LifeRule {
  std::uint16_t birth = 1u << 3;
  std::uint16_t survival = (1u << 2) | (1u << 3);
  LifeNeighbourhood neighbourhood = LifeNeighbourhood::moore;

  friend bool operator==(const LifeRule&, const LifeRule&) = default;
};

/// Reads "B3/S23", "23/3" (survival first, as Sinvhal 2005 writes it), either with a "V" behind it for the
/// von Neumann neighbourhood, or one of life_rule_names(), in any case. Throws InputError for anything else.
LifeRule parse_life_rule(std::string_view text);

/// The B/S form of a rule; parse_life_rule gives the same rule back.
std::string life_rule_text(const LifeRule& rule);

/// Named rules and their B/S forms.
const std::vector<std::pair<std::string, std::string>>& life_rule_names();

/// The rule as a behaviour, a byte a cell: what PackedLife is held against. What lies beyond a boundary is
/// dead.
struct LifeBehaviour {
  using State = std::uint8_t;
  static constexpr bool rests = true;
  LifeRule rule;

  State outside() const { return 0; }
  State next(const Neighbourhood<State>& n, const CellRandom&) const {
    int live = n.here[-1] + n.here[1] + *n.below + *n.above;
    if (rule.neighbourhood == LifeNeighbourhood::moore)
      live += n.below[-1] + n.below[1] + n.above[-1] + n.above[1];
    return static_cast<State>(((*n.here != 0 ? rule.survival : rule.birth) >> live) & 1);
  }
  template <std::size_t lanes>
  void next_lanes(const State* below, const State* here, const State* above, State* out) const {
    typedef State Lanes __attribute__((vector_size(lanes)));  // NOLINT(modernize-use-using)
    Lanes centre, live{}, next{};
    std::memcpy(&centre, here, sizeof centre);
    const auto count_in = [&](const State* from) {
      Lanes cells;
      std::memcpy(&cells, from, sizeof cells);
      live += cells;
    };
    for (const State* from : {here - 1, here + 1, below, above}) count_in(from);
    if (rule.neighbourhood == LifeNeighbourhood::moore)
      for (const State* from : {below - 1, below + 1, above - 1, above + 1}) count_in(from);
    for (unsigned count = 0; count <= 8; ++count) {
      const bool born = (rule.birth >> count & 1) != 0, stays = (rule.survival >> count & 1) != 0;
      if (!born && !stays) continue;
      const Lanes has = reinterpret_cast<Lanes>(live == static_cast<State>(count)) & 1;
      next |= born && stays ? has : born ? has & ~centre : has & centre;
    }
    std::memcpy(out, &next, sizeof next);
  }
};

}  // namespace verdigris
