#pragma once
// Model files in: OBJ, OFF, PLY and STL (text and binary), OM, GLB and glTF.

#include <cstddef>
#include <filesystem>
#include <string>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// What a file held and what reading did to it.
struct ReadReport {
  std::string format;  ///< "OBJ", "PLY (binary little-endian)", ...
  std::size_t file_vertices = 0;
  std::size_t file_faces = 0;
  std::size_t polygons_triangulated = 0;  ///< faces of more than three corners
  WeldReport weld;
};

/// Reads a model, chosen by the file's extension (content checked), triangulates polygons, welds vertices of
/// equal position. Texture coordinates and colours are kept per corner where the format has them.
///
/// Throws InputError naming the file, the line or byte, the problem and the remedy for: a missing file, a
/// directory or other non-file, an unknown extension, an empty or truncated file, counts in a header that the
/// file is too short to hold, numbers that are malformed or not finite, indices out of range, no triangles,
/// what a format requires and the reader does not know. Memory use is bounded by a small multiple of the
/// file's size.
Mesh read_mesh(const std::filesystem::path& file, ReadReport* report = nullptr);

}  // namespace verdigris
