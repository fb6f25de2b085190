#pragma once
// Meshes out, in formats that read_mesh reads back the same.

#include <filesystem>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// Writes positions and triangles, in full precision: .obj as text, .ply as binary. Throws InputError for
/// other endings, and when the file cannot be written; leaves none half written.
void write_mesh(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace verdigris
