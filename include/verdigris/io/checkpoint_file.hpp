#pragma once
// Checkpoints as files: one file each, versioned, with a checksum. docs/file-formats.md has the layout.

#include <filesystem>

#include "verdigris/automaton/checkpoint.hpp"

namespace verdigris {

/// Writes `checkpoint` aside, to disk, and then renames it over `file`: whatever happens, `file` is the one
/// before or this one, whole. Throws InputError when that cannot be done.
void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint);

/// Reads a checkpoint back. Throws InputError when there is none, and for a file that is none, of a format
/// version this program does not know, cut short, or damaged in any bit. Takes memory only for what the file
/// really holds.
Checkpoint read_checkpoint(const std::filesystem::path& file);

}  // namespace verdigris
