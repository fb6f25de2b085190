#pragma once

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// A mountain ridge with eroded valleys: a height map of 65 x 65 points 10 m apart, y up, heights in steps of
/// 0.1 m from 0; 8192 triangles, open at the border.
Mesh make_terrain();

}  // namespace verdigris::meshes
