#pragma once
// "Verify completeness of object": step 1 of the algorithm in Gobron & Chiba 1999, Appendix 2.

#include <cstddef>

#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// What a mesh consists of and what is wrong with it.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t unused_vertices = 0;  ///< vertices of no triangle
  std::size_t triangles = 0;
  std::size_t edges = 0;
  std::size_t components = 0;  ///< sets of triangles that share edges (of any kind)
  std::size_t boundary_edges = 0;
  std::size_t boundary_loops = 0;      ///< closed chains of boundary edges
  std::size_t non_manifold_edges = 0;  ///< edges of three triangles or more
  std::size_t non_manifold_vertices =
      0;                               ///< vertices whose triangles are not one fan, once bad edges are cut
  std::size_t inconsistent_edges = 0;  ///< edges of two triangles that run the same way along it
  std::size_t degenerate_triangles =
      0;  ///< area 0 to within rounding (height below 1e-12 of the longest edge)
  std::size_t duplicate_triangles = 0;  ///< triangles with the three vertices of an earlier one, in any order
  double area = 0.0;                    ///< model units squared
  Bounds bounds;
  double shortest_edge = 0.0, mean_edge = 0.0, longest_edge = 0.0;  ///< model units
  double smallest_height = 0.0;  ///< least height of a non-degenerate triangle over its longest edge

  bool closed() const { return boundary_edges + non_manifold_edges + inconsistent_edges == 0; }
};

/// Counts everything in MeshReport. Linear in the size of the mesh.
MeshReport inspect(const Mesh& mesh, const Adjacency& adjacency);

/// Triangles whose height over their longest edge is less than `cell_size`: there a ghost reads past a whole
/// triangle, and projected pairs carry growth across it in one step (Gobron & Chiba 1999, Fig. 9).
std::size_t triangles_narrower_than(const Mesh& mesh, double cell_size);

}  // namespace verdigris
