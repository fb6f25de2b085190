#pragma once
// Power spectra of square pictures that repeat: no window is needed.

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

namespace verdigris {

/// In place, radix 2, n a power of two; `step` between elements.
inline void fourier(std::complex<double>* data, std::size_t n, std::size_t step) {
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(data[i * step], data[j * step]);
  }
  for (std::size_t length = 2; length <= n; length *= 2) {
    const auto turn = std::polar(1.0, -2.0 * std::numbers::pi / static_cast<double>(length));
    for (std::size_t begin = 0; begin < n; begin += length) {
      std::complex<double> w = 1.0;
      for (std::size_t k = 0; k < length / 2; ++k, w *= turn) {
        auto &a = data[(begin + k) * step], &b = data[(begin + k + length / 2) * step];
        const std::complex<double> other = b * w;
        b = a - other;
        a += other;
      }
    }
  }
}

/// Power by frequency: [k] the sum over all waves of k - 1/2 to k + 1/2 cycles a side, `waves` of them.
struct RadialSpectrum {
  std::vector<double> power, waves;

  /// Sum over frequencies from `first` on, up to `end`.
  double between(std::size_t first, std::size_t end) const {
    double sum = 0.0;
    for (std::size_t k = first; k < end && k < power.size(); ++k) sum += power[k];
    return sum;
  }
};

/// Of `values` [y * side + x], side a power of two.
inline RadialSpectrum radial_spectrum(const std::vector<float>& values, std::size_t side) {
  std::vector<std::complex<double>> waves(values.begin(), values.end());
  for (std::size_t y = 0; y < side; ++y) fourier(&waves[y * side], side, 1);
  for (std::size_t x = 0; x < side; ++x) fourier(&waves[x], side, side);
  RadialSpectrum spectrum{std::vector<double>(side), std::vector<double>(side)};
  const auto signed_frequency = [&](std::size_t k) {
    return static_cast<double>(k) - (k > side / 2 ? static_cast<double>(side) : 0.0);
  };
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const auto k =
          static_cast<std::size_t>(std::lround(std::hypot(signed_frequency(x), signed_frequency(y))));
      spectrum.power[k] += std::norm(waves[y * side + x]);
      spectrum.waves[k] += 1.0;
    }
  return spectrum;
}

}  // namespace verdigris
