#pragma once
// A picture in memory.

#include <cstdint>
#include <vector>

namespace verdigris {

/// 8-bit RGBA, sRGB-encoded colours with straight alpha; rows from top to bottom without padding.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< [4 * (y * width + x) + channel]
};

/// 16-bit grey levels, for heights and other data rather than for the eye; rows from top to bottom.
struct GreyImage {
  int width = 0, height = 0;
  std::vector<std::uint16_t> levels;  ///< [y * width + x]
};

}  // namespace verdigris
