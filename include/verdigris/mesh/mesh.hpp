#pragma once
// The triangle mesh every other part starts from: plain arrays, never changed once a surface stands on it.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

namespace verdigris {

/// An indexed triangle mesh.
///
/// Positions are in model units and finite; indices are in range. Triangles are counter-clockwise seen from
/// outside. Vertices at one position are one vertex (`weld`), or growth would stop at texture seams; what
/// differs between the corners that meet there (texture coordinates, colours) is kept per corner.
struct Mesh {
  std::vector<glm::dvec3> positions;  ///< [vertex], model units
  std::vector<glm::uvec3> triangles;  ///< [triangle], three different vertices each
  std::vector<glm::vec2> corner_uv;   ///< [3 * triangle + corner], v upwards; or empty when the file has none
  std::vector<glm::vec4> corner_color;  ///< [3 * triangle + corner], RGBA in 0..1 as in the file, or empty
  std::vector<std::uint32_t> vertex_of_file;    ///< [vertex in file order] -> vertex; empty: the same order
  std::vector<std::uint32_t> face_of_triangle;  ///< [triangle] -> face in file order; empty: the same order

  /// Corner `k` (0..2) of `triangle`.
  const glm::dvec3& corner(std::size_t triangle, int k) const { return positions[triangles[triangle][k]]; }
};

/// What was done to the faces of a file to make triangles of them.
struct WeldReport {
  std::size_t vertices_welded = 0;  ///< vertices that repeated the position of an earlier one
  std::size_t collapsed_faces = 0;  ///< triangles dropped because two of their corners were one vertex
};

/// Makes vertices of exactly equal position (-0 equals 0) one vertex, the first of them in order, drops
/// triangles that thereby repeat a vertex, and drops nothing else. Corner attributes follow; the file maps
/// are composed. Linear in the size of the mesh.
Mesh weld(const Mesh& mesh, WeldReport* report = nullptr);

/// 128-bit hash (32 hexadecimal digits) of positions and triangles: equal geometry, equal hash, whatever the
/// file format. XXH3 over little-endian bytes.
std::string mesh_hash(const Mesh& mesh);

/// Sum of the triangle areas, in model units squared.
double mesh_area(const Mesh& mesh);

/// Axis-aligned bounds, in model units. A mesh without vertices has lower = upper = 0.
struct Bounds {
  glm::dvec3 lower{0.0}, upper{0.0};
};
Bounds mesh_bounds(const Mesh& mesh);

}  // namespace verdigris
