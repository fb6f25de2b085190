#pragma once
// Ghosts of a field that no simulation refreshes: they take the value of their owner, so that pictures of a
// mask have no seams.

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Gives each ghost the value of the cell it repeats. With projected links nothing is changed: there the
/// cells of a pair both hold values of their own.
template <typename T>
void copy_to_ghosts(const Surface& surface, Field<T>& field) {
  if (surface.link_kind() != LinkKind::unfolded) return;
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) field[target] = field[source];
  });
}

}  // namespace verdigris
