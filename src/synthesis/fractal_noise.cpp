#include "verdigris/synthesis/fractal_noise.hpp"

#include "octave_field.hpp"

namespace verdigris {

namespace {

using namespace synthesis;

struct Sum {
  std::vector<float> amplitude;
  void start(float* value, float*) const { std::fill_n(value, lanes, 0.0f); }
  void add(std::size_t i, float left, const float* noise, float* value, float*) const {
    const float factor = amplitude[i] * left;
    for (std::size_t k = 0; k < lanes; ++k) value[k] += factor * noise[k];
  }
};

struct AbsoluteSum {
  std::vector<float> amplitude;
  float mean;  ///< of |noise|: what stays of an octave that cannot be seen
  void start(float* value, float*) const { std::fill_n(value, lanes, 0.0f); }
  void add(std::size_t i, float left, const float* noise, float* value, float*) const {
    for (std::size_t k = 0; k < lanes; ++k)
      value[k] += amplitude[i] * (mean + left * (std::fabs(noise[k]) - mean));
  }
};

// Scaled so that independent octaves add up to the variance of one.
std::vector<float> normalised(std::vector<float> amplitude) {
  double square = 0.0;
  for (const float a : amplitude) square += static_cast<double>(a) * static_cast<double>(a);
  const double factor = 1.0 / std::sqrt(square);
  for (float& a : amplitude) a = static_cast<float>(static_cast<double>(a) * factor);
  return amplitude;
}

}  // namespace

std::unique_ptr<ScalarField> Fbm::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, series.octaves, series.lacunarity, seed);
  return octave_field(octaves, Sum{normalised(amplitudes(octaves.count(), series.lacunarity, series.H))});
}

std::unique_ptr<ScalarField> MultiresolutionSum::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, this->octaves, lacunarity, seed);
  std::vector<float> amplitude;
  for (std::size_t i = 0; i < octaves.count(); ++i)
    amplitude.push_back(static_cast<float>(std::pow(persistence, static_cast<double>(i))));
  return octave_field(octaves, Sum{normalised(std::move(amplitude))});
}

std::unique_ptr<ScalarField> Turbulence::make(std::uint64_t seed) const {
  OctaveSet octaves(lattice, series.octaves, series.lacunarity, seed);
  const float mean = octave_mean(lattice, seed, [](float n) { return std::fabs(n); });
  return octave_field(
      octaves, AbsoluteSum{normalised(amplitudes(octaves.count(), series.lacunarity, series.H)), mean});
}

}  // namespace verdigris
