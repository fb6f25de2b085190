#pragma once
// Pictures that the program wrote, read back.

#include <cstdint>
#include <filesystem>
#include <vector>

/// Linear levels 0 .. 65535, rows from the top; empty where there is no PNG.
std::vector<std::uint16_t> grey_levels(const std::filesystem::path& file);
