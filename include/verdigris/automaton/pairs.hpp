#pragma once
// "At the end of each turn" the data of an edge pair is made common (Gobron & Chiba 1999, "Edge Communication").

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/links.hpp"

namespace verdigris {

/// Slots and the states they take.
template <typename State>
using Merges = std::vector<std::pair<std::uint32_t, State>>;

/// What the partners of the slots in `sources` become, ascending by slot, only those that change. Reads the states as
/// they are before any of them is written: what a cell takes, it passes on in the next turn.
template <MergingBehaviour B, typename Slots>
Merges<typename B::State> merge_pairs(const Links& links, const B& behaviour, const Field<typename B::State>& state,
                                      const Slots& sources) {
  Merges<typename B::State> taken;
  for (const std::uint32_t source : sources)
    for (const std::uint32_t partner : links.targets(source))
      if (behaviour.merge(state[partner], state[source]) != state[partner]) taken.emplace_back(partner, state[source]);
  std::stable_sort(taken.begin(), taken.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Merges<typename B::State> merges;
  for (const auto& [slot, theirs] : taken) {
    if (merges.empty() || merges.back().first != slot) merges.emplace_back(slot, state[slot]);
    merges.back().second = behaviour.merge(merges.back().second, theirs);
  }
  return merges;
}

/// Every slot that has partners.
inline std::vector<std::uint32_t> paired_slots(const Links& links) {
  std::vector<std::uint32_t> slots;
  links.for_each([&](std::uint32_t slot, auto) { slots.push_back(slot); });
  return slots;
}

}  // namespace verdigris
