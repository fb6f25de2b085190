#pragma once
// Cracks of a shrinking layer: they open one after the other where stress is left, run until they meet
// another one, and release the stress around them.

#include <array>
#include <cstdint>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// How a layer cracks.
struct CrackSettings {
  double spacing = 0.1;  ///< model units: the square root of the mean area between cracks; at least 8 cells
  double wander = 0.25;  ///< radians a crack turns at random on a way of `spacing`
  double release = 0.8;  ///< how strongly the stress field turns tips across to the cracks they meet, 0..1
  std::uint64_t seed = 1;
};

/// The cracks of a surface.
struct CrackNetwork {
  Field<float> distance;             ///< [slot] cells to the nearest crack, as far as it counts; owned cells
  std::vector<std::uint32_t> cells;  ///< under cracks, in the order in which they opened
  std::uint64_t cracks = 0;
  double length = 0.0;                       ///< of all, model units
  std::array<std::uint64_t, 3> junctions{};  ///< of degree 3, 4, 5 and more
  std::uint64_t ends_at_rim = 0;             ///< at a boundary
  std::uint64_t ends_free = 0;               ///< where nothing cracks, or after a way round the model

  /// Share of junctions where three meet.
  double threes() const;
};

/// Grows the network. Stress at a place is what the distance to the nearest crack leaves of it (shear lag): a
/// crack opens where that distance is half the spacing or more, at flaws in random order; both its tips run
/// on, turn across the gradient of stress to meet older cracks squarely, and end there. So cracks form a
/// hierarchy with junctions of three, as in drying mud and glaze (Bohn, Pauchard & Couder 2005,
/// "Hierarchical crack pattern as formed by successive domain divisions"). `strain` [slot] 0..1 divides the
/// spacing, 0: no crack there; empty: 1. In one thread. Throws InputError for a spacing below eight cells.
CrackNetwork grow_cracks(const Surface& surface, const CrackSettings& settings,
                         const Field<float>& strain = {});

}  // namespace verdigris
