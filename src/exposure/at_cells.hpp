#pragma once
// A value at every evolving cell, in parallel over patches.

#include <tbb/parallel_for.h>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Calls visit(patch, slot, centre in the plane of the patch) for every evolving cell.
template <typename Visit>
void each_cell(const Surface& surface, Visit&& visit) {
  tbb::parallel_for(std::size_t{0}, surface.patch_count(), [&](std::size_t patch) {
    for (std::uint32_t r = surface.row_begin(patch); r < surface.row_end(patch); ++r) {
      const Row& row = surface.rows()[r];
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
        const auto column = static_cast<std::int32_t>(slot - row.base);
        visit(patch, slot, surface.centre(surface.grid_row(patch, r), column));
      }
    }
  });
}

/// value(patch, slot, centre in the plane of the patch) at every evolving cell; other slots hold 0.
template <typename Value>
Field<float> at_cells(const Surface& surface, Value&& value) {
  Field<float> field(surface.slot_count(), 0.0f);
  each_cell(surface, [&](std::size_t patch, std::uint32_t slot, glm::dvec2 centre) {
    field[slot] = static_cast<float>(value(patch, slot, centre));
  });
  return field;
}

/// Weights of corners A, B, C of a frame at a point of its plane.
inline glm::dvec3 corner_weights(const Frame& f, glm::dvec2 p) {
  const double c = f.cy > 0.0 ? p.y / f.cy : 0.0;
  const double b = f.ab > 0.0 ? (p.x - c * f.cx) / f.ab : 0.0;
  return {1.0 - b - c, b, c};
}

}  // namespace verdigris
