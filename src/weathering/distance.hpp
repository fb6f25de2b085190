#pragma once
// Distances over the surface from cells that are given, across edges too.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "cells.hpp"
#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris::weathering {

/// Of slots that show no owned cell.
inline constexpr std::uint32_t no_owner = 0xFFFFFFFFu;

/// [slot] the owned cell that it is or, for a ghost, shows.
inline std::vector<std::uint32_t> owners_of(const Surface& surface) {
  std::vector<std::uint32_t> owners = ghost_sources(surface, no_owner);
  each_owned(surface, [&](std::uint32_t slot) { owners[slot] = slot; });
  return owners;
}

/// Carries the distance outwards from `sources`, in cells, to owned cells whose `distance` it makes less:
/// what stands there limits how far it goes. reached(slot, from) for each, by way of which neighbour; a
/// source by way of itself. Weights of Borgefors 1986, "Distance transformations in digital images": off by
/// 4.5 % at most. In one thread.
template <typename Reached>
void carry_distance(const Surface& surface, std::span<const std::uint32_t> owners,
                    std::span<const std::uint32_t> sources, Field<float>& distance, Reached&& reached) {
  constexpr float side = 0.95509f, corner = 1.36930f;
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto set = [&](std::uint32_t slot, std::uint32_t from, float d) {
    distance[slot] = d;
    queue.emplace(d, slot);
    reached(slot, from);
  };
  for (const std::uint32_t slot : sources) set(slot, slot, 0.0f);
  while (!queue.empty()) {
    const auto [d, slot] = queue.top();
    queue.pop();
    if (d > distance[slot]) continue;
    const auto n = around(surface, slot);
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint32_t s = owners[n[k]];
      const float far = d + (k % 2 == 0 ? side : corner);
      if (s != no_owner && far < distance[s]) set(s, slot, far);
    }
  }
}

}  // namespace verdigris::weathering
