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

}  // namespace verdigris
