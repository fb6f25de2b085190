#pragma once

#include <functional>
#include <glm/vec3.hpp>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// The surface where `distance`, negative inside, is 0, as triangles of about `cell` (surface nets: Gibson
/// 1998, "Constrained elastic surface nets"). Closed when the surface lies within the box.
Mesh mesh_of_implicit(const std::function<double(glm::dvec3)>& distance, glm::dvec3 lower, glm::dvec3 upper,
                      double cell);

/// Distances: a capsule with the radii `ra` at `a` and `rb` at `b` (nearly, where they differ), an ellipsoid
/// (nearly), a ring about an axis of the coordinates.
double capsule(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double ra, double rb);
double ellipsoid(glm::dvec3 p, glm::dvec3 centre, glm::dvec3 radii);
double ring(glm::dvec3 p, glm::dvec3 centre, int axis, double major, double minor);
/// Both together, their seam rounded over `blend`.
double join(double a, double b, double blend);

}  // namespace verdigris::meshes
