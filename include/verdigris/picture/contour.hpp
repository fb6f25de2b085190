#pragma once
// Where the centred lines of the grids cross the edges of the triangles: the contour points of the bands.
// Source: Gobron & Chiba 1999, "Triangle Strips and Triangle Fans".

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// An edge in the grid coordinates of one of its triangles, always run from the vertex of lower index to the
/// other.
struct EdgeInPlane {
  glm::dvec2 from, to;
};

/// A crossing strictly between the ends of an edge.
struct ContourPoint {
  double t;          ///< 0 at the vertex of lower index, 1 at the other
  std::int32_t row;  ///< grid row of the asking triangle whose centred line passes here, or -1
};

/// Appends the crossings of the centred lines x = (i + 1/2) h and y = (j + 1/2) h of the asking triangle's
/// grid, and of the grid across if there is one, in ascending t. Points closer than 1e-6 cells are one, those
/// so close to an end are left to the corner. `length` is that of the edge in model space.
///
/// Both triangles of an edge get the same t, bit for bit, so that their bands meet without a crack.
void edge_contour(const EdgeInPlane& own, const EdgeInPlane* across, double length, double cell_size,
                  std::vector<ContourPoint>& points);

/// An edge of a triangle of a surface, with the triangle across; corners are numbered as in Frame (0 = A).
struct SharedEdge {
  std::uint32_t across;     ///< the opposite half-edge, or Adjacency::none
  bool reversed;            ///< the own triangle runs it from the higher vertex to the lower one
  EdgeInPlane own, other;   ///< `other` only when there is a triangle across
  glm::dvec3 from, to;      ///< ends in model space
  std::uint32_t low, high;  ///< their vertices
};
SharedEdge shared_edge(const Surface& surface, std::uint32_t patch, int frame_edge);

}  // namespace verdigris
