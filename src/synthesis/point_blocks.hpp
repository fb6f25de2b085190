#pragma once
// Points taken a block of lanes at a time, the last one filled up, coordinates that were left out as zeros.

#include <algorithm>
#include <array>
#include <utility>

#include "lattice.hpp"
#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris::synthesis {

/// Coordinates of `lanes` points.
struct PointBlock {
  std::array<const double*, 4> axis{};  ///< [axis][lane]
};

/// Calls values(block, result) for each block and copies result [lanes] to `out`.
template <typename Values>
void for_blocks(const Points& points, std::span<float> out, Values&& values) {
  static constexpr double zeros[lanes] = {};
  const std::array<std::span<const double>, 4> given{points.x, points.y, points.z, points.w};
  double filled[4][lanes];
  float result[lanes];
  for (std::size_t first = 0; first < points.size(); first += lanes) {
    const std::size_t count = std::min(lanes, points.size() - first);
    PointBlock block;
    for (std::size_t a = 0; a < 4; ++a) {
      if (given[a].empty()) {
        block.axis[a] = zeros;
      } else if (count == lanes) {
        block.axis[a] = given[a].data() + first;
      } else {
        std::fill(std::copy_n(given[a].data() + first, count, filled[a]), filled[a] + lanes, 0.0);
        block.axis[a] = filled[a];
      }
    }
    values(std::as_const(block), result);
    std::copy_n(result, count, out.data() + first);
  }
}

}  // namespace verdigris::synthesis
