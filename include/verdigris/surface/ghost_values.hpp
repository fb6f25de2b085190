#pragma once
// Ghosts of values that no simulation refreshes: they take those of their owners, so that pictures have no
// seams.

#include <cstdint>
#include <span>

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

}  // namespace verdigris
