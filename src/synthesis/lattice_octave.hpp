#pragma once
// How one octave of noise lies in space.

#include <array>
#include <cstdint>

#include "lattice.hpp"

namespace verdigris::synthesis {

/// A lattice with random numbers of its own.
struct LatticeOctave {
  double frequency = 1.0;  ///< cells per unit
  std::uint32_t seed = 0;
  std::uint32_t cells = 0;  ///< cells in a period; 0: endless
  std::array<LatticeAxis, 4> axes;

  /// How much of it is left, 0..1, when samples lie `footprint` units apart: all of it while a cell spans
  /// four samples, nothing below two.
  float fade(double footprint) const;
  double cell() const { return 1.0 / frequency; }
};

/// Octave `index` of a noise with `seed`: its seed and its shift are its own, so that lattices do not meet.
/// With a period (not 0) the frequency is rounded to whole cells in it. Throws InputError when the period
/// holds no cell, or the octave has more than 1e9 cells per unit.
LatticeOctave lattice_octave(double frequency, double period, std::uint64_t seed, std::uint32_t index);

}  // namespace verdigris::synthesis
