#pragma once
// A height field as a mesh.

#include "verdigris/mesh/mesh.hpp"
#include "verdigris/synthesis/height_map.hpp"

namespace verdigris {

/// A vertex for each sample, `map.step` apart, y up: x runs along the rows from 0, z down the columns,
/// towards the viewer, from 0; y is the value times `scale`. Two triangles a square, cut along the diagonal
/// whose ends differ less in height, so that ridges and valleys are not notched; all face up. Throws
/// std::invalid_argument for fewer than 2 x 2 samples, or not as many as the size says, and
/// std::length_error for more than 4e9.
Mesh height_mesh(const HeightMap& map, double scale);

/// The same as a closed solid: walls down to y = base, and a floor. Throws std::invalid_argument for a base
/// that is not below all heights too.
Mesh height_solid(const HeightMap& map, double scale, double base);

}  // namespace verdigris
