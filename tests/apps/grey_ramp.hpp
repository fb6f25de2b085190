#pragma once
// Images for masks; apart, for the program's tests call a function what the library calls its namespace.

#include <filesystem>

/// A 16-bit PNG whose level is `step` times the column.
void write_grey_ramp(const std::filesystem::path& file, int width, int height, int step);
