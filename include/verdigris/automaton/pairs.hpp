#pragma once
// "At the end of each turn" the data of an edge pair is made common (Gobron & Chiba 1999, "Edge
// Communication").

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>
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
/// A cell that takes a state hands it on in the same turn over the other edges of its triangle, but not back
/// over the one it came by. So a triangle narrower than a cell is passed at once: what Fig. 9 of the paper
/// warns of. Only states from before the turn decide who takes what; the order of pairs cannot matter.
template <MergingBehaviour B, typename Slots>
Merges<typename B::State> merge_pairs(const Surface& surface, const B& behaviour,
                                      const Field<typename B::State>& state, const Slots& sources) {
  struct Passing {
    std::uint32_t slot, from_patch, patch;
    typename B::State value;
    auto key() const { return std::tuple(slot, from_patch, value); }
  };
  const auto patch_of = [&](std::uint32_t slot) { return surface.patch_of_row(surface.row_of(slot)); };
  constexpr std::uint32_t nowhere = 0xFFFFFFFFu;

  std::vector<Passing> wave, next;
  for (const std::uint32_t source : sources)
    if (surface.links().is_source(source)) wave.push_back({source, nowhere, patch_of(source), state[source]});
  const auto by_key = [](const Passing& a, const Passing& b) { return a.key() < b.key(); };
  const auto same = [](const Passing& a, const Passing& b) { return a.key() == b.key(); };
  std::vector<Passing> taken;
  while (!wave.empty()) {
    next.clear();
    for (const Passing& p : wave)
      for (const std::uint32_t partner : surface.links().targets(p.slot)) {
        if (behaviour.merge(state[partner], p.value) == state[partner]) continue;
        const std::uint32_t patch = patch_of(partner);
        if (patch != p.from_patch) next.push_back({partner, p.patch, patch, p.value});
      }
    std::sort(next.begin(), next.end(), by_key);
    next.erase(std::unique(next.begin(), next.end(), same), next.end());
    // Only what was not there before goes on: rings of thin triangles come back to where they began.
    wave.clear();
    std::set_difference(next.begin(), next.end(), taken.begin(), taken.end(), std::back_inserter(wave),
                        by_key);
    const auto middle = static_cast<std::ptrdiff_t>(taken.size());
    taken.insert(taken.end(), wave.begin(), wave.end());
    std::inplace_merge(taken.begin(), taken.begin() + middle, taken.end(), by_key);
  }

  Merges<typename B::State> merges;
  for (const Passing& p : taken) {
    if (merges.empty() || merges.back().first != p.slot) merges.emplace_back(p.slot, state[p.slot]);
    merges.back().second = behaviour.merge(merges.back().second, p.value);
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
