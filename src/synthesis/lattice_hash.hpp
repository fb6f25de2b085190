#pragma once
// A random word for every lattice point, by arithmetic alone: tables would have to be gathered.

#include <cstdint>

namespace verdigris::synthesis {

/// Odd constants, one an axis, that spread neighbouring cells over all words.
inline constexpr std::uint32_t axis_key[4] = {0x9e3779b1u, 0x85ebca6bu, 0xc2b2ae35u, 0x27d4eb2fu};

/// One round of mixing: shift down, multiply. What comes out is good in its upper bits.
inline std::uint32_t mix(std::uint32_t word) {
  word ^= word >> 15;
  return word * 0x2c1b3c6du;
}

/// x and y are mixed first, so that the corners of a cell share that round. Keys are cells times axis_key.
inline std::uint32_t plane_word(std::uint32_t seed, std::uint32_t x_key, std::uint32_t y_key) {
  return mix((seed + x_key) ^ y_key);
}
/// The other axes need no shift: `plane` is mixed already, and only upper bits are used. `key` holds theirs,
/// by exclusive or; 0 in 2D.
inline std::uint32_t point_word(std::uint32_t plane, std::uint32_t key) {
  return (plane ^ key) * 0x297a2d39u;
}

}  // namespace verdigris::synthesis
