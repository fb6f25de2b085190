#pragma once
// The octaves of a noise: the same lattice again and again, finer each time.

#include <cstdint>
#include <vector>

#include "lattice_octave.hpp"
#include "point_blocks.hpp"
#include "verdigris/synthesis/lattice_noise.hpp"

namespace verdigris::synthesis {

/// Several octaves of lattice noise.
class OctaveSet {
 public:
  /// Octave i has frequency * lacunarity^i cells per unit. Throws InputError as lattice_octave does.
  OctaveSet(const NoiseLattice& lattice, int count, double lacunarity, std::uint64_t seed);

  std::size_t count() const { return octaves_.size(); }
  const LatticeOctave& operator[](std::size_t i) const { return octaves_[i]; }
  /// Octave i at `points`, within -1..1: out [lanes].
  void sample(std::size_t i, const PointBlock& points, float* out) const;

 private:
  bool gradient_;
  int dimensions_;
  std::vector<LatticeOctave> octaves_;
};

/// One octave as a field, of either basis.
std::unique_ptr<ScalarField> one_octave(const NoiseLattice& lattice, std::uint64_t seed);

}  // namespace verdigris::synthesis
