#pragma once
// Ghosts of values that no simulation refreshes: they take those of their owners, so that pictures have no
// seams.

#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Gives each ghost the value of the cell it repeats; `values` [slot]. With projected links nothing is
/// changed: there the cells of a pair both hold values of their own.
template <typename Values>
void copy_to_ghosts(const Surface& surface, Values&& values) {
  if (surface.link_kind() != LinkKind::unfolded) return;
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) values[target] = values[source];
  });
}

/// [slot] the cell that a ghost repeats; `none` for all other slots.
inline std::vector<std::uint32_t> ghost_sources(const Surface& surface, std::uint32_t none = 0xFFFFFFFFu) {
  std::vector<std::uint32_t> sources(surface.slot_count(), none);
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) sources[target] = source;
  });
  return sources;
}

}  // namespace verdigris
