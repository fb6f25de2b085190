#pragma once
// Gradient noise at one point (Perlin 2002, "Improving Noise": quintic fade, few fixed gradients),
// branch-free so that loops over it become vector instructions. Values lie within -1..1.

#include <bit>
#include <cstdint>

#include "lattice_hash.hpp"

namespace verdigris::synthesis {

/// Keys of the lattice points below and above a point along each axis, and where between them.
template <int dimension>
struct LatticePoint {
  std::uint32_t below[dimension], above[dimension];
  float fraction[dimension];  ///< 0..1
};

/// 6 t^5 - 15 t^4 + 10 t^3: no kink in the second derivative at cell borders.
inline float fade(float t) {
  return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}
inline float mixed(float a, float b, float t) {
  return a + t * (b - a);
}

/// `value`, its sign turned where bit `bit` of `word` is set.
template <int bit>
float signed_by(float value, std::uint32_t word) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) ^ ((word << (31 - bit)) & 0x80000000u));
}

/// Distance (x, y, ..) from a corner times the corner's gradient, chosen by the upper bits of `word`.
/// 2D: eight directions, 45 degrees apart and none along an axis.
inline float along_gradient(std::uint32_t word, float x, float y) {
  const float u = (word & 0x20000000u) != 0 ? x : y, v = (word & 0x20000000u) != 0 ? y : x;
  return signed_by<31>(0.92387953f * u, word) + signed_by<30>(0.38268343f * v, word);
}
/// 3D: the middles of a cube's twelve edges, one axis left out in a third of all cases each. (Sixteen choices
/// with four of the twelve repeated, as in 2002, make slopes along y a tenth steeper.)
inline float along_gradient(std::uint32_t word, float x, float y, float z) {
  const float u = word < 0x55555555u ? y : x, v = word < 0xaaaaaaaau ? z : y;
  return signed_by<20>(u, word) + signed_by<19>(v, word);
}
/// 4D: one axis left out, the others by sign.
inline float along_gradient(std::uint32_t word, float x, float y, float z, float w) {
  const std::uint32_t without = word >> 30;
  const float a = without == 0 ? y : x, b = without <= 1 ? z : y, c = without <= 2 ? w : z;
  return signed_by<29>(a, word) + signed_by<28>(b, word) + signed_by<27>(c, word);
}

// The greatest sums the gradients allow, found by a search over the cell.
inline constexpr float greatest_2d = 0.6608165f, greatest_3d = 1.0363539f, greatest_4d = 1.5365824f;

inline float gradient_noise(std::uint32_t seed, const LatticePoint<2>& p) {
  const float x0 = p.fraction[0], y0 = p.fraction[1], x1 = x0 - 1.0f, y1 = y0 - 1.0f;
  const auto corner = [&](std::uint32_t x_key, std::uint32_t y_key, float x, float y) {
    return along_gradient(point_word(plane_word(seed, x_key, y_key), 0), x, y);
  };
  const float u = fade(x0), v = fade(y0);
  const float low = mixed(corner(p.below[0], p.below[1], x0, y0), corner(p.above[0], p.below[1], x1, y0), u);
  const float high = mixed(corner(p.below[0], p.above[1], x0, y1), corner(p.above[0], p.above[1], x1, y1), u);
  return mixed(low, high, v) * (1.0f / greatest_2d);
}

inline float gradient_noise(std::uint32_t seed, const LatticePoint<3>& p) {
  const float x0 = p.fraction[0], y0 = p.fraction[1], z0 = p.fraction[2];
  const float x1 = x0 - 1.0f, y1 = y0 - 1.0f, z1 = z0 - 1.0f;
  const float u = fade(x0), v = fade(y0), w = fade(z0);
  const std::uint32_t h00 = plane_word(seed, p.below[0], p.below[1]),
                      h10 = plane_word(seed, p.above[0], p.below[1]),
                      h01 = plane_word(seed, p.below[0], p.above[1]),
                      h11 = plane_word(seed, p.above[0], p.above[1]);
  const auto layer = [&](std::uint32_t key, float z) {
    const float low = mixed(along_gradient(point_word(h00, key), x0, y0, z),
                            along_gradient(point_word(h10, key), x1, y0, z), u);
    const float high = mixed(along_gradient(point_word(h01, key), x0, y1, z),
                             along_gradient(point_word(h11, key), x1, y1, z), u);
    return mixed(low, high, v);
  };
  return mixed(layer(p.below[2], z0), layer(p.above[2], z1), w) * (1.0f / greatest_3d);
}

inline float gradient_noise(std::uint32_t seed, const LatticePoint<4>& p) {
  const float x0 = p.fraction[0], y0 = p.fraction[1], x1 = x0 - 1.0f, y1 = y0 - 1.0f;
  const float u = fade(x0), v = fade(y0), s = fade(p.fraction[2]), t = fade(p.fraction[3]);
  const std::uint32_t h00 = plane_word(seed, p.below[0], p.below[1]),
                      h10 = plane_word(seed, p.above[0], p.below[1]),
                      h01 = plane_word(seed, p.below[0], p.above[1]),
                      h11 = plane_word(seed, p.above[0], p.above[1]);
  const auto layer = [&](std::uint32_t key, float z, float w) {
    const float low = mixed(along_gradient(point_word(h00, key), x0, y0, z, w),
                            along_gradient(point_word(h10, key), x1, y0, z, w), u);
    const float high = mixed(along_gradient(point_word(h01, key), x0, y1, z, w),
                             along_gradient(point_word(h11, key), x1, y1, z, w), u);
    return mixed(low, high, v);
  };
  const auto solid = [&](std::uint32_t w_key, float w) {
    return mixed(layer((p.below[2]) ^ w_key, p.fraction[2], w),
                 layer((p.above[2]) ^ w_key, p.fraction[2] - 1.0f, w), s);
  };
  return mixed(solid(p.below[3], p.fraction[3]), solid(p.above[3], p.fraction[3] - 1.0f), t) *
         (1.0f / greatest_4d);
}

}  // namespace verdigris::synthesis
