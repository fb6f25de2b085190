#pragma once

#include <cstddef>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// What a sound mesh is, in numbers.
struct Shape {
  std::size_t triangles = 0, boundary_edges = 0, pieces = 0;
  long euler = 0;          ///< vertices - edges + triangles
  double area = 0;         ///< model units squared
  double volume = 0;       ///< positive when the triangles of a closed mesh face outward
  double least_angle = 0;  ///< degrees, the sharpest corner of all
};

/// Measures a mesh. Throws std::runtime_error unless it is an oriented two-manifold (with boundary): no
/// unused vertex, no triangle without area, every edge run through at most once each way, one fan or ring of
/// triangles round every vertex, no two triangles crossing.
Shape inspect(const Mesh& mesh);

}  // namespace verdigris::meshes
