#pragma once
// The files of materials/, built into the library: it finds them wherever it runs.

#include <span>
#include <string_view>

namespace verdigris::io {

struct EmbeddedMaterial {
  std::string_view name, text;
};

/// In alphabetical order. The source is made by cmake/EmbedMaterials.cmake.
std::span<const EmbeddedMaterial> embedded_materials();

/// Where they are installed, for those who want to change them.
std::string_view material_directory();

}  // namespace verdigris::io
