#pragma once
// Which triangle lies across which edge, and which edges cannot be crossed.

#include <cstdint>
#include <vector>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// What kind of thing an edge of a triangle is.
enum class EdgeKind : std::uint8_t {
  linked,        ///< exactly two triangles, of opposite direction along the edge: it can be crossed
  boundary,      ///< one triangle only
  non_manifold,  ///< three triangles or more
  inconsistent,  ///< two triangles that run along the edge in the same direction (orientation differs)
};

/// Half-edge `3 * triangle + k` runs from corner k to corner k + 1 (mod 3) of its triangle.
struct Adjacency {
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::vector<std::uint32_t> opposite;  ///< [half-edge] -> half-edge of the triangle across, or none
  std::vector<EdgeKind> kind;           ///< [half-edge]
};

/// Links every edge that has exactly two triangles of opposite direction. All others are cut: a link that
/// would have to be guessed is never made. Linear in the number of triangles; the same result in any thread
/// count.
Adjacency make_adjacency(const Mesh& mesh);

}  // namespace verdigris
