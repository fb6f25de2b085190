#pragma once
// One reader a format. Each takes the file's bytes, names `file` in what it throws, fills `report` except
// for what welding did, and returns a mesh that is not welded yet.

#include <filesystem>

#include "file_bytes.hpp"
#include "verdigris/io/read_mesh.hpp"

namespace verdigris::io {

Mesh read_obj(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);
Mesh read_off(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);
Mesh read_ply(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);
Mesh read_stl(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);
Mesh read_om(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);
Mesh read_gltf(FileBytes bytes, const std::filesystem::path& file, ReadReport& report);

}  // namespace verdigris::io
