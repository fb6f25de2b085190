#pragma once
// The masks of a scene file.

#include <toml++/toml.h>
#include <filesystem>
#include <string>
#include <vector>

#include "verdigris/io/scene.hpp"

namespace verdigris::io {

/// Those of [masks.NAME]; files are relative to the scene's. Throws InputError with file and line.
std::vector<MaskPlan> read_masks(const std::filesystem::path& file, const toml::table& root);

/// Its table, for a scene in `file`.
std::string mask_text(const MaskPlan& mask, const std::filesystem::path& file);

}  // namespace verdigris::io
