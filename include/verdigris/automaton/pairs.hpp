#pragma once
// "At the end of each turn" the data of an edge pair is made common (Gobron & Chiba 1999, "Edge
// Communication").

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Slots and the states they take.
template <typename State>
using Merges = std::vector<std::pair<std::uint32_t, State>>;

/// What cells become when the pairs of `sources` are made common; ascending by slot, only those that change.
///
/// In a triangle narrower than a cell, a cell that takes a state hands it on in the same turn over the other
/// edges, not back over the one it came by: such a triangle is passed at once, which is what Fig. 9 of the
/// paper warns of. Only states from before the turn decide who takes what; the order of pairs cannot matter.
template <MergingBehaviour B, typename Slots>
Merges<typename B::State> merge_pairs(const Surface& surface, const B& behaviour,
                                      const Field<typename B::State>& state, const Slots& sources) {
  using State = typename B::State;
  struct Passing {
    std::uint32_t slot, from_patch, patch;
    State value;
  };
  const auto patch_of = [&](std::uint32_t slot) { return surface.patch_of_row(surface.row_of(slot)); };
  constexpr std::uint32_t nowhere = 0xFFFFFFFFu;

  std::vector<Passing> wave, next;
  for (const std::uint32_t source : sources)
    if (surface.links().is_source(source)) wave.push_back({source, nowhere, patch_of(source), state[source]});
  // What came to a slot from a patch: a state goes on only where it makes a difference there.
  std::unordered_map<std::uint64_t, State> taken;
  while (!wave.empty()) {
    next.clear();
    for (const Passing& p : wave)
      for (const std::uint32_t partner : surface.links().targets(p.slot)) {
        const State before = state[partner];
        if (behaviour.merge(before, p.value) == before) continue;
        const std::uint32_t patch = patch_of(partner);
        if (patch == p.from_patch) continue;
        const auto [at, fresh] = taken.try_emplace(std::uint64_t{partner} << 32 | p.patch, before);
        const State merged = behaviour.merge(at->second, p.value);
        if (merged == at->second) continue;
        at->second = merged;
        if (surface.frame(patch).cy < surface.cell_size()) next.push_back({partner, p.patch, patch, merged});
      }
    wave.swap(next);
  }

  Merges<State> merges;
  for (const auto& [key, value] : taken) merges.emplace_back(static_cast<std::uint32_t>(key >> 32), value);
  std::sort(merges.begin(), merges.end());
  std::size_t count = 0;
  for (const auto& [slot, value] : merges) {
    if (count > 0 && merges[count - 1].first == slot)
      merges[count - 1].second = behaviour.merge(merges[count - 1].second, value);
    else
      merges[count++] = {slot, value};
  }
  merges.resize(count);
  return merges;
}

/// Every slot that has partners.
inline std::vector<std::uint32_t> paired_slots(const Links& links) {
  std::vector<std::uint32_t> slots;
  links.for_each([&](std::uint32_t slot, auto) { slots.push_back(slot); });
  return slots;
}

}  // namespace verdigris
