#pragma once
// Fractals that are not the same everywhere (Musgrave, in Ebert et al., "Texturing & Modeling", and Musgrave,
// Kolb & Mace 1989): the roughness of a place depends on what lies there already.

#include <cstdint>
#include <memory>

#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris {

/// The product of (1 + a_i n_i / offset), a_i = lacunarity^(-H i): plains where a coarse octave is near
/// -offset, heaped detail where all are high. Around 1, 0 or more where offset is at least 1. The cascade of
/// the textbooks, product of (n_i + offset) lacunarity^(-H i), where H is but a constant factor, is this one
/// with H = 0.
struct Multifractal {
  static constexpr const char *name = "multifractal", *summary = "multiplicative multifractal: a cascade";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  OctaveSeries series{.H = 0.5};
  double offset = 0.8;

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
    v("offset", offset, 0.05, 100.0, "1", "raised, the multifractal becomes an fbm; lowered, it gets wilder");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

/// The hybrid multifractal: each octave is weighted by the value so far, clamped to 0..1. Low places are
/// smooth, high ones rough, as worn land is.
struct HybridMultifractal {
  static constexpr const char *name = "hybrid",
                              *summary = "hybrid multifractal: rough heights above smooth valleys";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  OctaveSeries series{.H = 0.25};
  double offset = 0.7;

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
    v("offset", offset, 0.0, 10.0, "1", "added to each octave: how much of the land is high");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

/// The ridged multifractal: (offset - |n|)^2, which has ridges where n changes sign, each octave weighted by
/// the one before, so that ridges carry ridges.
struct RidgedMultifractal {
  static constexpr const char *name = "ridged", *summary = "ridged multifractal: crests that carry crests";
  static constexpr int dimension = 4;
  NoiseLattice lattice{};
  OctaveSeries series{};
  double offset = 1.0, gain = 2.0;

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
    v("offset", offset, 0.0, 2.0, "1", "height of the ridges before they are squared");
    v("gain", gain, 0.0, 10.0, "1", "how strongly an octave roughens the next; 0: not, all places are alike");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

}  // namespace verdigris
