#pragma once
// Connected regions of cells and the length of their rims.

#include <cstdint>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// What stands in a slot when spots are measured.
enum class SpotCell : std::uint8_t {
  out,      ///< a cell that is in no spot
  in,       ///< a cell of a spot
  nothing,  ///< no cell: beyond a boundary, a barrier
};

/// Spots: owned cells joined over sides, corners and edges between triangles.
struct Spots {
  std::vector<std::uint64_t> sizes;  ///< cells of each, the largest first
  double perimeter = 0.0;            ///< model units; towards `nothing` there is no rim
};

/// Union-find over cells and links, linear in the number of slots, 4 bytes a slot while it runs. The
/// perimeter is Crofton's: pi / 8 of a cell for each pair of side neighbours of which one is in, and
/// sqrt(1/2) of that for corner neighbours; right on average over directions, 5 % short for a straight rim
/// along the grid. `cells` holds a value for each slot, ghosts like their owners.
Spots measure_spots(const Surface& surface, const Field<SpotCell>& cells);

/// How many spots have 1, 2..3, 4..7, 8..15, ... cells.
std::vector<std::uint64_t> spot_histogram(const Spots& spots);

}  // namespace verdigris
