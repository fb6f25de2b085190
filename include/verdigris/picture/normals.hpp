#pragma once
// Normals for lighting: smooth where the surface is, crisp at creases.

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// Unit normals [3 * triangle + corner]: the angle-weighted mean of the triangles around the vertex that can
/// be reached from this one without crossing a cut edge or one whose two faces turn by more than
/// `crease_angle` degrees. 0 gives flat triangles, 180 smooths everything. A triangle of no area neither
/// counts nor makes a crease.
std::vector<glm::vec3> corner_normals(const Mesh& mesh, const Adjacency& adjacency,
                                      double crease_angle = 40.0);

}  // namespace verdigris
