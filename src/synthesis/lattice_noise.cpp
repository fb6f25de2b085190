#include "verdigris/synthesis/lattice_noise.hpp"

#include "octaves.hpp"

namespace verdigris {

namespace {

using namespace synthesis;

class OneOctave final : public ScalarField {
 public:
  OneOctave(const NoiseLattice& lattice, std::uint64_t seed) : octave_(lattice, 1, 2.0, seed) {}
  ValueRange range() const override { return {-1.0f, 1.0f, true}; }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    const float left = octave_[0].fade(footprint);
    for_blocks(points, out, [&](const PointBlock& block, float* value) {
      octave_.sample(0, block, value);
      for (std::size_t k = 0; k < lanes; ++k) value[k] *= left;
    });
  }
  OctaveSet octave_;
};

}  // namespace

std::unique_ptr<ScalarField> synthesis::one_octave(const NoiseLattice& lattice, std::uint64_t seed) {
  return std::make_unique<OneOctave>(lattice, seed);
}

std::unique_ptr<ScalarField> GradientNoise::make(std::uint64_t seed) const {
  NoiseLattice own = lattice;
  own.basis = "gradient";
  return one_octave(own, seed);
}

std::unique_ptr<ScalarField> ValueNoise::make(std::uint64_t seed) const {
  NoiseLattice own = lattice;
  own.basis = "value";
  return one_octave(own, seed);
}

}  // namespace verdigris
