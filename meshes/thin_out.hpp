#pragma once

#include <cstddef>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// The same surface with about `triangles` triangles, small ones where it bends and large ones where it is
/// flat: edges are collapsed into one of their ends in the order of quadric errors (Garland & Heckbert 1997,
/// "Surface simplification using quadric error metrics"), and none whose triangles would turn by more than
/// 25 degrees.
Mesh thin_out(const Mesh& mesh, std::size_t triangles);

}  // namespace verdigris::meshes
