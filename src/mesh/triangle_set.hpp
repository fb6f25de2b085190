#pragma once
// Which triangles have the vertices of an earlier one.

#include <cstdint>
#include <vector>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// [triangle] -> whether an earlier triangle has the same three vertices, in any order. Linear.
std::vector<bool> duplicate_triangles(const Mesh& mesh);

}  // namespace verdigris
