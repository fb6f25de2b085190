#pragma once
// Finding the joints: which cell each ghost copies, and which cells are paired across an edge.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nearest.hpp"

namespace verdigris {

/// (source slot << 32 | target slot), in ascending order of target within one patch.
struct Joints {
  std::vector<std::uint64_t> pairs;
  std::size_t open = 0;  ///< ghosts beyond a boundary or barrier
  std::size_t lost = 0;  ///< ghosts over surface that owns no cell near
};

/// Ghosts of one patch, each with the owned cell nearest to its unfolded centre. Appends to `joints`.
void find_ghosts(const PatchRows& rows, const Unfolding& unfolding, std::uint32_t patch, Joints& joints);

/// Pairs across the edges of `patch` whose half-edge is the lower of the two (Gobron & Chiba 1999, "Edge
/// Communication"): each cell that the edge crosses with the cell on the other side whose projection on the
/// edge is nearest, both ways. Appends to `joints`, each pair in both directions.
void find_edge_pairs(const PatchRows& rows, const Unfolding& unfolding, std::uint32_t patch, Joints& joints);

}  // namespace verdigris
