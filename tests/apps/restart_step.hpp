#pragma once
// The step a checkpoint stands at. Apart from program.hpp, whose function has the name of the library's
// namespace.

#include <cstdint>
#include <filesystem>

/// Throws for a file that is no whole checkpoint.
std::uint64_t checkpoint_step(const std::filesystem::path& file);
