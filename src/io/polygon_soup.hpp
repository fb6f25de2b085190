#pragma once
// What a file holds before it is a mesh: faces of any number of corners, with the attributes formats have.

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "verdigris/io/read_mesh.hpp"

namespace verdigris::io {

/// Faces as the file has them. Attributes that a file does not have are empty.
struct PolygonSoup {
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  std::vector<glm::dvec3> positions;         ///< [vertex]
  std::vector<glm::vec4> vertex_color;       ///< [vertex]
  std::vector<glm::vec2> vertex_uv;          ///< [vertex]
  std::vector<std::uint32_t> corner_vertex;  ///< [corner]
  std::vector<std::uint32_t> corner_uv;      ///< [corner] -> place in `uv`, or none
  std::vector<glm::vec2> uv;                 ///< what corner_uv points to
  std::vector<std::uint32_t> face_end;       ///< [face] -> one past its last corner
  std::vector<glm::vec4> face_color;         ///< [face]

  std::size_t faces() const { return face_end.size(); }
  std::size_t face_begin(std::size_t face) const { return face == 0 ? 0 : face_end[face - 1]; }
};

/// Triangulates; indices must be in range. Fills the counts of `report`. Throws InputError naming `file` when
/// there is no face, a face has too many corners, or there are more triangles than 32-bit half-edges can
/// number.
Mesh to_mesh(PolygonSoup&& soup, const std::filesystem::path& file, ReadReport& report);

}  // namespace verdigris::io
