#include "octaves.hpp"

#include "gradient_noise.hpp"
#include "value_noise.hpp"

namespace verdigris::synthesis {

namespace {

template <int dimension>
LatticePoint<dimension> lane(const AxisBlock* axes, std::size_t k) {
  LatticePoint<dimension> point;
  for (int a = 0; a < dimension; ++a) {
    point.below[a] = axes[a].key_below[k];
    point.above[a] = axes[a].key_above[k];
    point.fraction[a] = axes[a].fraction[k];
  }
  return point;
}

template <int dimension>
void noise_block(bool gradient, const LatticeOctave& octave, const PointBlock& points,
                 float* __restrict out) {
  AxisBlock blocks[dimension];
  for (std::size_t a = 0; a < dimension; ++a) split_axis(octave.axes[a], a, points.axis[a], blocks[a]);
  if (gradient)
    for (std::size_t k = 0; k < lanes; ++k) out[k] = gradient_noise(octave.seed, lane<dimension>(blocks, k));
  else
    for (std::size_t k = 0; k < lanes; ++k) out[k] = value_noise(octave.seed, lane<dimension>(blocks, k));
}

}  // namespace

OctaveSet::OctaveSet(const NoiseLattice& lattice, int count, double lacunarity, std::uint64_t seed)
    : gradient_(lattice.basis == "gradient"), dimensions_(lattice.dimensions) {
  double frequency = lattice.frequency;
  for (int i = 0; i < count; ++i, frequency *= lacunarity)
    octaves_.push_back(lattice_octave(frequency, lattice.period, seed, static_cast<std::uint32_t>(i)));
}

void OctaveSet::sample(std::size_t i, const PointBlock& points, float* out) const {
  switch (dimensions_) {
    case 2:
      return noise_block<2>(gradient_, octaves_[i], points, out);
    case 3:
      return noise_block<3>(gradient_, octaves_[i], points, out);
    default:
      return noise_block<4>(gradient_, octaves_[i], points, out);
  }
}

}  // namespace verdigris::synthesis
