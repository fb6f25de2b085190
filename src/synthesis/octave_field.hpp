#pragma once
// A scalar field made of octaves, by a rule that says how they combine.

#include <cmath>
#include <utility>
#include <vector>

#include "octaves.hpp"
#include "sampled_values.hpp"

namespace verdigris::synthesis {

/// lacunarity^(-H i) for each octave.
inline std::vector<float> amplitudes(std::size_t count, double lacunarity, double H) {
  std::vector<float> list;
  for (std::size_t i = 0; i < count; ++i)
    list.push_back(static_cast<float>(std::pow(lacunarity, -H * static_cast<double>(i))));
  return list;
}

/// The mean of shape(n) over the values n of one octave.
template <typename Shape>
float octave_mean(const NoiseLattice& lattice, std::uint64_t seed, Shape&& shape) {
  NoiseLattice endless = lattice;
  endless.period = 0.0;
  return sampled_mean(*one_octave(endless, seed), 1.0 / lattice.frequency, shape);
}

/// `Rule` has `void start(float* value, float* weight) const`, all octaves' beginning, and
/// `void add(std::size_t octave, float left, const float* noise, float* value, float* weight) const` over
/// `lanes` lanes. `left`, 0..1, is what the sampling leaves of the octave; where it is 0, `noise` is 0 too.
template <typename Rule>
class OctaveField final : public ScalarField {
 public:
  OctaveField(OctaveSet octaves, Rule rule) : octaves_(std::move(octaves)), rule_(std::move(rule)) {}
  ValueRange range() const override { return sampled_range(*this, octaves_[0].cell()); }

 private:
  void compute(const Points& points, double footprint, std::span<float> out) const override {
    for_blocks(points, out, [&](const PointBlock& block, float* value) {
      float noise[lanes], weight[lanes];
      rule_.start(value, weight);
      for (std::size_t i = 0; i < octaves_.count(); ++i) {
        const float left = octaves_[i].fade(footprint);
        if (left > 0.0f)
          octaves_.sample(i, block, noise);
        else
          std::fill_n(noise, lanes, 0.0f);
        rule_.add(i, left, noise, value, weight);
      }
    });
  }
  OctaveSet octaves_;
  Rule rule_;
};

template <typename Rule>
std::unique_ptr<ScalarField> octave_field(OctaveSet octaves, Rule rule) {
  return std::make_unique<OctaveField<Rule>>(std::move(octaves), std::move(rule));
}

}  // namespace verdigris::synthesis
