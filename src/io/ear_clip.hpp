#pragma once
// Polygons into triangles.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace verdigris::io {

/// Faces of more corners than this are refused: cutting them takes time that grows with the square.
constexpr std::size_t most_corners = 10000;

/// Cuts one polygon of four or more corners, given by their positions in order, into triangles of corner
/// numbers, which are appended to `out`. Works in the polygon's own plane (Newell's normal), cuts the ear
/// with the shortest diagonal first, keeps the polygon's orientation. Repeated corners are skipped; a polygon
/// that is nothing but repeats gives one triangle that collapses. Self-crossing polygons give n - 2 triangles
/// that may overlap.
///
/// Ear clipping: G. Meisters, "Polygons have ears", 1975.
void triangulate_polygon(std::span<const glm::dvec3> corners, std::vector<std::array<std::uint32_t, 3>>& out);

}  // namespace verdigris::io
