#pragma once
// Dimension by box counting: how the number of boxes that a set meets grows as they get smaller.

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <span>
#include <unordered_set>
#include <vector>

namespace boxes {

/// How many boxes of side `size` hold one of `points`, which lie within +-2^20 boxes.
inline std::size_t count(std::span<const glm::dvec3> points, double size) {
  std::unordered_set<std::uint64_t> met;
  for (const glm::dvec3& p : points) {
    std::uint64_t key = 0;
    for (int k = 0; k < 3; ++k)
      key = key << 21 | (static_cast<std::uint64_t>(std::floor(p[k] / size) + 1048576.0) & 0x1FFFFFu);
    met.insert(key);
  }
  return met.size();
}

/// Slope of log(count) over log(1 / size) by least squares.
inline double dimension(std::span<const glm::dvec3> points, std::initializer_list<double> sizes) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const double size : sizes) {
    const double x = -std::log(size), y = std::log(static_cast<double>(count(points, size)));
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace boxes
