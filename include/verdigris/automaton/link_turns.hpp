#pragma once
// How far the frame of a ghost is turned against the frame of its owner.

#include <cstdint>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// [index into links().all_targets()] the turn from the owner's frame to the ghost's, counter-clockwise, in
/// multiples of 45 degrees (0..7), rounded to the nearest. Between triangles that share an edge it is the
/// rigid motion of Gobron & Chiba 1999, "Edge Communication", about that edge; between others the least
/// rotation that brings one plane onto the other, which is the same wherever the surface is flat. Linear in
/// the number of links; the same result for any number of threads.
std::vector<std::uint8_t> link_turns(const Surface& surface);

/// The turn from the frame of patch `from` to that of patch `to`, in eighths as above.
unsigned frame_turn(const Surface& surface, std::uint32_t from, std::uint32_t to);

}  // namespace verdigris
