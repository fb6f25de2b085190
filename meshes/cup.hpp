#pragma once

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// A coffee cup with thick walls, a handle towards +x and a foot ring; millimetres, standing on y = 0.
/// One closed surface: the handle grows out of two openings left in the outer wall.
Mesh make_cup();

}  // namespace verdigris::meshes
