#pragma once
// The table [animation] of a scene file.

#include <toml++/toml.h>
#include <filesystem>
#include <string>

#include "verdigris/io/animation_plan.hpp"

namespace verdigris::io {

/// Throws InputError with file and line.
AnimationPlan read_animation(const std::filesystem::path& file, const toml::table& root);

/// The table; nothing for a plan of defaults.
std::string animation_text(const AnimationPlan& plan);

}  // namespace verdigris::io
