#pragma once
// Points split into lattice cells and fractions, a block at a time: all that noise does in double.

#include <bit>
#include <cstddef>
#include <cstdint>

#include "lattice_hash.hpp"

namespace verdigris::synthesis {

/// Points handled at once. Loops over lanes have this length, and compilers make vector instructions of them.
inline constexpr std::size_t lanes = 128;

/// One coordinate of a block of points: which cell of the lattice, and where in it.
struct AxisBlock {
  std::uint32_t cell[lanes];
  std::uint32_t key_below[lanes],
      key_above[lanes];   ///< of the lattice points below and above: times axis_key
  float fraction[lanes];  ///< 0..1
};

/// How one octave's lattice lies along one axis.
struct LatticeAxis {
  double frequency = 1.0;  ///< cells per unit; with a period: cells per period
  double offset = 0.0;     ///< cells, 0..1
  double period = 0.0;     ///< units; 0: none
};

/// `value` as the nearest whole number, modulo 2^32, and the rest, -1/2..1/2. Exact up to 2^51, then
/// anything.
struct Nearest {
  std::uint32_t whole;
  double rest;
};
inline Nearest nearest(double value) {
  // Adding 1.5 * 2^52 rounds to a whole number and leaves it in the low bits: no conversion that overflows,
  // and the same few instructions with and without vectors.
  constexpr double shift = 6755399441055744.0;
  const double shifted = value + shift;
  return {static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(shifted)), value - (shifted - shift)};
}

/// `value` as its floor, modulo 2^32, and a fraction. The fraction is 0..1 whatever comes: a value too great
/// to have one, or none at all, lies at a border of its cell.
struct CellPlace {
  std::uint32_t cell;
  float fraction;
};
inline CellPlace cell_place(double value) {
  const Nearest n = nearest(value);
  const auto rest = static_cast<float>(n.rest);
  const bool under = rest < 0.0f;
  const float fraction = under ? rest + 1.0f : rest;
  const float below_one = fraction < 1.0f ? fraction : 1.0f;
  return {n.whole - static_cast<std::uint32_t>(under), below_one > 0.0f ? below_one : 0.0f};
}

/// Splits `x` [lanes] along axis `a` of a lattice.
inline void split_axis(const LatticeAxis& axis, std::size_t a, const double* x, AxisBlock& block) {
  const std::uint32_t key = axis_key[a];
  if (axis.period == 0.0) {
    for (std::size_t k = 0; k < lanes; ++k) {
      const CellPlace place = cell_place(x[k] * axis.frequency + axis.offset);
      block.cell[k] = place.cell;
      block.key_below[k] = place.cell * key;
      block.key_above[k] = place.cell * key + key;
      block.fraction[k] = place.fraction;
    }
    return;
  }
  const auto cells = static_cast<std::uint32_t>(axis.frequency);
  for (std::size_t k = 0; k < lanes; ++k) {
    const double rest = nearest(x[k] / axis.period).rest, turn = rest < 0.0 ? rest + 1.0 : rest;
    const CellPlace place = cell_place(turn * axis.frequency + axis.offset);
    const std::uint32_t cell = place.cell >= cells ? place.cell - cells : place.cell;
    block.cell[k] = cell;
    block.key_below[k] = cell * key;
    block.key_above[k] = cell + 1 == cells ? 0 : cell * key + key;
    block.fraction[k] = place.fraction;
  }
}

}  // namespace verdigris::synthesis
