#pragma once
// The header of a PLY file: which elements it has, and of what each row consists.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "faults.hpp"

namespace verdigris::io {

enum class PlyFormat : std::uint8_t { text, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t rows = 0;
  std::size_t offset = 0;  ///< of its line in the header, for messages
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< bytes up to the first row
};

/// Reads the header; throws InputError when it is malformed, does not end, or announces more rows than the
/// rest of the file can hold. G. Turk, "The PLY Polygon File Format", 1994.
PlyHeader read_ply_header(Faults& faults);

}  // namespace verdigris::io
