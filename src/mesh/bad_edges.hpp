#pragma once
// The edges that adjacency does not cross although they have more than one triangle.

#include <algorithm>
#include <vector>

#include "verdigris/mesh/adjacency.hpp"

namespace verdigris {

/// One side of such an edge.
struct BadSide {
  std::uint32_t lower, upper;  ///< the edge's vertices
  std::uint32_t half_edge;

  bool same_edge(const BadSide& other) const { return lower == other.lower && upper == other.upper; }
};

/// All sides of non-manifold and inconsistent edges, those of one edge next to each other.
std::vector<BadSide> bad_sides(const Mesh& mesh, const Adjacency& adjacency);

/// [half-edge] -> half-edge of the other triangle, for every edge of exactly two triangles, whichever way
/// they run; else none.
std::vector<std::uint32_t> two_sided_links(const Adjacency& adjacency, const std::vector<BadSide>& bad);

/// Calls `visit(first, last)` with the range of sides of each edge in `bad`.
template <class Visit>
void for_each_bad_edge(const std::vector<BadSide>& bad, Visit visit) {
  for (auto first = bad.begin(); first != bad.end();) {
    const auto last =
        std::find_if_not(first, bad.end(), [first](const BadSide& s) { return s.same_edge(*first); });
    visit(first, last);
    first = last;
  }
}

}  // namespace verdigris
