#pragma once
// Value noise at one point: a random value at each lattice point, mixed by the same fade as gradient noise.
// Values lie within -1..1.

#include <cstdint>

#include "gradient_noise.hpp"

namespace verdigris::synthesis {

/// -1..1 by all bits of the word.
inline float corner_value(std::uint32_t word) {
  return static_cast<float>(static_cast<std::int32_t>(word)) * 0x1p-31f;
}

/// The words of the four corners along x and y.
struct PlaneWords {
  std::uint32_t word[4];

  template <int dimension>
  PlaneWords(std::uint32_t seed, const LatticePoint<dimension>& p)
      : word{plane_word(seed, p.below[0], p.below[1]), plane_word(seed, p.above[0], p.below[1]),
             plane_word(seed, p.below[0], p.above[1]), plane_word(seed, p.above[0], p.above[1])} {}

  /// Their values at `key` of the other axes, mixed by the fades u and v.
  float value(std::uint32_t key, float u, float v) const {
    const float low =
        mixed(corner_value(point_word(word[0], key)), corner_value(point_word(word[1], key)), u);
    const float high =
        mixed(corner_value(point_word(word[2], key)), corner_value(point_word(word[3], key)), u);
    return mixed(low, high, v);
  }
};

inline float value_noise(std::uint32_t seed, const LatticePoint<2>& p) {
  return PlaneWords(seed, p).value(0, fade(p.fraction[0]), fade(p.fraction[1]));
}

inline float value_noise(std::uint32_t seed, const LatticePoint<3>& p) {
  const PlaneWords plane(seed, p);
  const float u = fade(p.fraction[0]), v = fade(p.fraction[1]);
  return mixed(plane.value(p.below[2], u, v), plane.value(p.above[2], u, v), fade(p.fraction[2]));
}

inline float value_noise(std::uint32_t seed, const LatticePoint<4>& p) {
  const PlaneWords plane(seed, p);
  const float u = fade(p.fraction[0]), v = fade(p.fraction[1]), s = fade(p.fraction[2]);
  const std::uint32_t z0 = p.below[2], z1 = p.above[2];
  const std::uint32_t w0 = p.below[3], w1 = p.above[3];
  return mixed(mixed(plane.value(z0 ^ w0, u, v), plane.value(z1 ^ w0, u, v), s),
               mixed(plane.value(z0 ^ w1, u, v), plane.value(z1 ^ w1, u, v), s), fade(p.fraction[3]));
}

}  // namespace verdigris::synthesis
