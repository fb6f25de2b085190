#pragma once
// Points split into lattice cells and fractions, a block at a time: all that noise does in double.

#include <bit>
#include <cstddef>
#include <cstdint>

namespace verdigris::synthesis {

/// Points handled at once. Loops over lanes have this length, and compilers make vector instructions of them.
inline constexpr std::size_t lanes = 128;

/// One coordinate of a block of points: the lattice cell below and above, and where between them.
struct AxisBlock {
  std::uint32_t below[lanes], above[lanes];
  float fraction[lanes];  ///< 0..1
};

/// How one octave's lattice lies along one axis.
struct LatticeAxis {
  double frequency = 1.0;  ///< cells per unit; with a period: cells per period
  double offset = 0.0;     ///< cells, 0..1
  double period = 0.0;     ///< units; 0: none
};

/// `value` as floor and rest. The floor wraps at 2^32; the rest is exact up to 2^51, and anything beyond.
struct Split {
  std::uint32_t floor;
  double rest;
};
inline Split split(double value) {
  // Adding 1.5 * 2^52 rounds to a whole number and leaves it in the low bits: no conversion that overflows,
  // and the same few instructions with and without vectors.
  constexpr double shift = 6755399441055744.0;
  const double shifted = value + shift;
  const double rest = value - (shifted - shift);
  const auto nearest = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(shifted));
  const bool under = rest < 0.0;
  return {nearest - static_cast<std::uint32_t>(under), under ? rest + 1.0 : rest};
}

/// 0..1, whatever comes: a coordinate too great to have a fraction, or none at all, gives a border of its
/// cell.
inline float narrowed(double rest) {
  const auto fraction = static_cast<float>(rest);
  const float below_one = fraction < 1.0f ? fraction : 1.0f;
  return below_one > 0.0f ? below_one : 0.0f;
}

/// Splits `x` [lanes] along one axis of a lattice.
inline void split_axis(const LatticeAxis& axis, const double* x, AxisBlock& block) {
  if (axis.period == 0.0) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const Split s = split(x[k] * axis.frequency + axis.offset);
      block.below[k] = s.floor;
      block.above[k] = s.floor + 1;
      block.fraction[k] = narrowed(s.rest);
    }
    return;
  }
  const auto cells = static_cast<std::uint32_t>(axis.frequency);
  for (std::size_t k = 0; k < lanes; ++k) {
    const double turn = split(x[k] / axis.period).rest;
    const Split s = split(turn * axis.frequency + axis.offset);
    const std::uint32_t below = s.floor >= cells ? s.floor - cells : s.floor;
    block.below[k] = below;
    block.above[k] = below + 1 == cells ? 0 : below + 1;
    block.fraction[k] = narrowed(s.rest);
  }
}

}  // namespace verdigris::synthesis
