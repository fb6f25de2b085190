#pragma once
// The owned cell whose centre is nearest to a point of the unfolded surface.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "verdigris/surface/surface.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris {

/// Rows of all patches while the surface is being built, or after.
struct PatchRows {
  std::span<const Row> rows;
  std::span<const std::uint32_t> row_begin;
  std::span<const SlotRun> comp_in;  ///< empty: every evolving cell is owned
  double cell_size;

  SlotRun owned(std::uint32_t row) const {
    return comp_in.empty() ? SlotRun{rows[row].run_begin, rows[row].run_end} : comp_in[row];
  }
};

/// A cell found, and how far its centre lies from the point, in cells.
struct NearestCell {
  std::uint32_t slot;
  double distance;
};

constexpr std::uint32_t no_patch = 0xFFFFFFFFu;

/// Searches `patch` and, where it has no cell close by, the patches around it, all unfolded into its plane;
/// `point` is in that plane. Never looks into `except`, nor past barriers, nor farther than `reach` cells or
/// `most_patches`. Equal distances: the lowest slot.
std::optional<NearestCell> nearest_cell(const PatchRows& rows, const Unfolding& unfolding,
                                        std::uint32_t patch, glm::dvec2 point, std::uint32_t except,
                                        double reach, std::size_t most_patches);

}  // namespace verdigris
