#pragma once
// The table [weathering] and the list [[timeline]] of a scene file.

#include <toml++/toml.h>
#include <filesystem>
#include <string>

#include "verdigris/io/weathering_plan.hpp"

namespace verdigris::io {

/// A material's file is relative to the scene's. Throws InputError with file and line, also for operators,
/// parameters and masks there are not; `own_masks` are the names of the scene's.
WeatheringPlan read_weathering(const std::filesystem::path& file, const toml::table& root,
                               const std::vector<std::string>& own_masks);

/// Table and list, for a scene in `file`; nothing for an empty plan.
std::string weathering_text(const WeatheringPlan& plan, const std::filesystem::path& file);

}  // namespace verdigris::io
