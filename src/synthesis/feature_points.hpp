#pragma once
// The feature points of cellular noise and distances to them, branch-free.

#include <cmath>
#include <cstdint>

#include "lattice_hash.hpp"

namespace verdigris::synthesis {

enum class Metric { euclidean, manhattan, chebyshev };

/// From a point to the feature point of the cell with word `word`; `x`, `y`, `z` lead to the middle of that
/// cell. Euclidean distances are squared. In 2D `z` is not used.
template <int dimension, Metric metric>
float feature_distance(std::uint32_t word, float x, float y, float z, float jitter) {
  const std::uint32_t first = mix(word);
  // 16 bits of position a coordinate, -1/2..1/2.
  constexpr float step = 0x1p-16f;
  const float dx = x + jitter * (static_cast<float>(static_cast<std::int32_t>(word >> 16)) * step - 0.5f);
  const float dy = y + jitter * (static_cast<float>(static_cast<std::int32_t>(first >> 16)) * step - 0.5f);
  float dz = 0.0f;
  if constexpr (dimension == 3)
    dz = z + jitter * (static_cast<float>(static_cast<std::int32_t>(mix(first) >> 16)) * step - 0.5f);
  if constexpr (metric == Metric::euclidean) {
    return dx * dx + dy * dy + dz * dz;
  } else {
    const float ax = std::fabs(dx), ay = std::fabs(dy), az = std::fabs(dz);
    if constexpr (metric == Metric::manhattan) return ax + ay + az;
    const float axy = ax > ay ? ax : ay;
    return axy > az ? axy : az;
  }
}

/// The two least distances met. The least of a set does not depend on the order in which it is looked
/// through.
inline void keep_nearest(float distance, float& f1, float& f2) {
  const float farther = distance > f1 ? distance : f1;
  f2 = farther < f2 ? farther : f2;
  f1 = distance < f1 ? distance : f1;
}

}  // namespace verdigris::synthesis
