#include "verdigris/synthesis/multifractals.hpp"

#include "octave_field.hpp"

namespace verdigris {

namespace {

using namespace synthesis;

float clamped(float x) {
  return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

struct Cascade {
  std::vector<float> amplitude;  ///< over the offset
  void start(float* value, float*) const { std::fill_n(value, lanes, 1.0f); }
  void add(std::size_t i, float left, const float* noise, float* value, float*) const {
    const float factor = amplitude[i] * left;
    for (std::size_t k = 0; k < lanes; ++k) value[k] *= 1.0f + factor * noise[k];
  }
};

struct Hybrid {
  std::vector<float> amplitude;
  float offset;
  void start(float* value, float* weight) const {
    std::fill_n(value, lanes, 0.0f);
    std::fill_n(weight, lanes, 1.0f);
  }
  void add(std::size_t i, float left, const float* noise, float* value, float* weight) const {
    for (std::size_t k = 0; k < lanes; ++k) {
      const float signal = amplitude[i] * (left * noise[k] + offset);
      value[k] += weight[k] * signal;
      weight[k] = clamped(weight[k] * signal);
    }
  }
};

struct Ridged {
  std::vector<float> amplitude;
  float offset, gain, mean;  ///< mean of the squared ridge
  void start(float* value, float* weight) const {
    std::fill_n(value, lanes, 0.0f);
    std::fill_n(weight, lanes, 1.0f);
  }
  void add(std::size_t i, float left, const float* noise, float* value, float* weight) const {
    for (std::size_t k = 0; k < lanes; ++k) {
      const float ridge = offset - std::fabs(noise[k]);
      const float signal = weight[k] * (mean + left * (ridge * ridge - mean));
      value[k] += amplitude[i] * signal;
      weight[k] = gain > 0.0f ? clamped(signal * gain) : 1.0f;
    }
  }
};

}  // namespace

std::unique_ptr<ScalarField> Multifractal::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, series.octaves, series.lacunarity, seed);
  std::vector<float> amplitude = amplitudes(octaves.count(), series.lacunarity, series.H);
  for (float& a : amplitude) a /= static_cast<float>(offset);
  return octave_field(octaves, Cascade{std::move(amplitude)});
}

std::unique_ptr<ScalarField> HybridMultifractal::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, series.octaves, series.lacunarity, seed);
  return octave_field(
      octaves, Hybrid{amplitudes(octaves.count(), series.lacunarity, series.H), static_cast<float>(offset)});
}

std::unique_ptr<ScalarField> RidgedMultifractal::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, series.octaves, series.lacunarity, seed);
  const auto height = static_cast<float>(offset);
  const float mean =
      octave_mean(lattice, seed, [&](float n) { return (height - std::fabs(n)) * (height - std::fabs(n)); });
  return octave_field(octaves, Ridged{amplitudes(octaves.count(), series.lacunarity, series.H), height,
                                      static_cast<float>(gain), mean});
}

}  // namespace verdigris
