#pragma once
// The simple closed solids that tests, benchmarks and figures start from. The axis of all is y.

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// Edges of length 1, centred on the origin, 12 triangles.
Mesh make_cube();

/// An icosahedron whose triangles are split into four `splits` times, every vertex on the unit sphere.
Mesh make_sphere(int splits);

/// A tube of radius `minor` round a circle of radius `major`, `around` x `across` quads of two triangles.
Mesh make_torus(double major, double minor, int around, int across);

/// A closed cylinder from y = 0 to `length`: each side one quad of two triangles, the ends fans round a
/// vertex.
Mesh make_cylinder(double radius, double length, int sides);

/// A twisted vase of five pentagons and two poles, the upper pole sunk in: 50 triangles, one closed surface.
Mesh make_vase();

}  // namespace verdigris::meshes
