#pragma once
// Surfaces of revolution from rings of different vertex counts, mirror images of themselves in the xy plane.

#include <cstdint>
#include <vector>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// One horizontal ring about the y axis: `2 * angles.size() - 2` vertices, or a single one when `angles` is
/// empty. Vertex i lies at angle angles[i], vertex count - i at -angles[i]; counter-clockwise seen from
/// above.
struct Ring {
  std::vector<double> angles;           ///< radians, from 0 to pi, ascending
  std::vector<std::uint32_t> vertices;  ///< all the way round, from angle 0

  std::uint32_t at(int i) const;  ///< vertex i, counted round: -1 is the last
};

/// `count` (even) angles of equal spacing, the upper half of them.
std::vector<double> even_angles(int count);

/// The same, but the two columns beside angle 0 are `width` radians wide, the others share the rest.
std::vector<double> angles_with_columns(int count, double width);

/// Appends the vertices of a ring at height `y`.
Ring add_ring(Mesh& mesh, double radius, double y, std::vector<double> angles);

/// Appends a single vertex on the axis.
Ring add_pole(Mesh& mesh, double y);

/// Joins two rings that follow each other along the profile: up the outer wall, down the inner one, so that
/// the triangles face away from the solid. With `opening`, leaves out the two columns beside angle 0.
void stitch(Mesh& mesh, const Ring& from, const Ring& to, bool opening = false);

}  // namespace verdigris::meshes
