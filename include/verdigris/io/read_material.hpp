#pragma once
// Materials as data: one TOML file each.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/material/material.hpp"

namespace verdigris {

/// Reads a material (docs/file-formats.md). Throws InputError with file and line for TOML that does not
/// parse, keys that do not exist or are missing, and values of the wrong type or out of range.
Material read_material(const std::filesystem::path& file);

/// The same from a text; `where` stands for the file in messages.
Material parse_material(std::string_view text, const std::string& where);

/// A material by name, "copper", or by file, "my/own.toml" (whatever ends in .toml). Names are looked for
/// among the installed files, then among those built into the library. Throws InputError that lists them.
Material find_material(const std::string& name);

/// The names that find_material knows, in alphabetical order.
std::vector<std::string> material_names();

}  // namespace verdigris
