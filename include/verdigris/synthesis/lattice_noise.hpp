#pragma once
// Noise on a lattice, one octave: the raw material of all others.

#include <cstdint>
#include <memory>
#include <string>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris {

/// Where noise comes from and how it lies in space.
struct NoiseLattice {
  std::string basis = "gradient";  ///< "gradient" or "value"
  int dimensions = 3;              ///< coordinates read: 2, 3 or 4
  double frequency = 4.0;          ///< lattice cells per unit, of the first octave
  double period =
      0.0;  ///< units after which it repeats along every axis; frequencies are rounded to fit. 0: never

  template <typename V>
  void parameters(V&& v) {
    v("basis", basis, {"gradient", "value"}, "what each octave is: gradient or value noise");
    lattice_parameters(v);
  }
  /// All but the basis.
  template <typename V>
  void lattice_parameters(V&& v) {
    v("dimensions", dimensions, 2, 4, "1", "coordinates it reads; 2 is fastest, models need 3");
    v("frequency", frequency, 1e-6, 1e6, "1/unit", "features per unit of length, of the coarsest octave");
    v("period", period, 0.0, 1e6, "unit", "repeat after this length along every axis; 0: never");
  }
};

/// Gradient noise (Perlin 1985, with the quintic fade and fixed gradients of Perlin 2002, "Improving Noise").
/// 0 at every lattice point, within -1..1. The lattice is shifted by the seed.
struct GradientNoise {
  static constexpr const char *name = "gradient", *summary = "gradient noise (Perlin), one octave";
  static constexpr int dimension = 4;
  NoiseLattice lattice{.frequency = 8.0};  ///< its basis is gradient noise, whatever it says

  template <typename V>
  void parameters(V&& v) {
    lattice.lattice_parameters(v);
  }
  /// Throws InputError when the period is shorter than half a cell.
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

/// Value noise: a random value at every lattice point, mixed in between. Within -1..1.
struct ValueNoise {
  static constexpr const char *name = "value", *summary = "value noise, one octave";
  static constexpr int dimension = 4;
  NoiseLattice lattice{.basis = "value", .frequency = 8.0};  ///< its basis is value noise, whatever it says

  template <typename V>
  void parameters(V&& v) {
    lattice.lattice_parameters(v);
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

}  // namespace verdigris
