#pragma once

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// The unit square in the plane z = 0, facing +z: a jittered grid of `cells` x `cells`, Delaunay triangulated
/// into 2 * cells^2 triangles. Its border is exactly the square's.
Mesh make_sheet(int cells);

}  // namespace verdigris::meshes
