#pragma once
// The table [corrosion] of a scene file.

#include <toml++/toml.h>
#include <filesystem>
#include <string>

#include "verdigris/io/corrosion_plan.hpp"

namespace verdigris::io {

/// A material's file is relative to the scene's. Throws InputError with file and line.
CorrosionPlan read_corrosion(const std::filesystem::path& file, const toml::table& root);

/// The table, for a scene in `file`; nothing for an empty plan.
std::string corrosion_text(const CorrosionPlan& plan, const std::filesystem::path& file);

}  // namespace verdigris::io
