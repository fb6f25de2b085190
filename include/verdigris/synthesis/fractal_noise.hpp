#pragma once
// Sums of octaves: fractional Brownian motion and its relatives. The same everywhere and in every direction.

#include <cstdint>
#include <memory>

#include "verdigris/synthesis/lattice_noise.hpp"

namespace verdigris {

/// How the octaves of a fractal follow each other. Octave i has the amplitude lacunarity^(-H i).
struct OctaveSeries {
  int octaves = 8;
  double lacunarity = 2.03;  ///< a little off 2, so that the lattices of the octaves do not pile up
  double H = 1.0;            ///< 1: smooth, 0: as rough as can be

  template <typename V>
  void parameters(V&& v) {
    v("octaves", octaves, 1, 32, "1", "how many scales; those finer than the sampling cost nothing");
    v("lacunarity", lacunarity, 1.1, 8.0, "1", "each octave is finer by this factor");
    v("h", H, 0.0, 2.0, "1", "how fast octaves weaken: 1 is smooth, near 0 is roughest");
  }
};

/// Fractional Brownian motion (Mandelbrot & Van Ness 1968) as a sum of octaves (Musgrave, in Ebert et al.,
/// "Texturing & Modeling"). The power spectrum falls as frequency^-(2 H + E) in E dimensions. Its variance is
/// that of one octave, whatever H and the number of octaves.
struct Fbm {
  static constexpr const char *name = "fbm", *summary = "fractional Brownian motion: a sum of octaves";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  OctaveSeries series{};

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
  }
  /// Throws InputError for a period without a cell and for octaves finer than 1e9 cells per unit; so do all
  /// that are made of octaves.
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

/// The sum of Noise(2^i p) / 2^i (Perlin 1985), persistence and lacunarity being free. Variance as of fbm.
struct MultiresolutionSum {
  static constexpr const char *name = "multiresolution",
                              *summary = "multiresolution noise: each octave half as strong as the last";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  int octaves = 8;
  double lacunarity = 2.0, persistence = 0.5;

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    v("octaves", octaves, 1, 32, "1", "how many scales; those finer than the sampling cost nothing");
    v("lacunarity", lacunarity, 1.1, 8.0, "1", "each octave is finer by this factor");
    v("persistence", persistence, 0.0, 1.0, "1", "each octave is weaker by this factor");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

/// Turbulence (Perlin 1985): the octaves of fbm by absolute value, which leaves creases. 0 or more.
struct Turbulence {
  static constexpr const char *name = "turbulence",
                              *summary = "turbulence: octaves by absolute value, creased";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  OctaveSeries series{};

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

}  // namespace verdigris
