#pragma once
// L-systems from files.

#include <filesystem>

#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {

/// Reads a grammar file: see parse_lsystem for its form. Throws InputError with file, line and column.
LSystem read_lsystem(const std::filesystem::path& file);

}  // namespace verdigris
