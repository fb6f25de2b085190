#pragma once
// Domain warp: an fbm looked at through another.

#include <cstdint>
#include <memory>

#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris {

/// fbm(p + strength * (fbm_1(p), fbm_2(p), ..)): flowing, folded shapes (Perlin 1985 for marble; Ebert et
/// al.).
struct DomainWarp {
  static constexpr const char *name = "warp", *summary = "domain warp: an fbm displaced by others";
  static constexpr int dimension = 4;
  NoiseLattice lattice{.frequency = 2.0};
  OctaveSeries series{};
  double strength = 0.3;
  int warp_octaves = 3;

  template <typename V>
  void parameters(V&& v) {
    lattice.parameters(v);
    series.parameters(v);
    v("strength", strength, 0.0, 1e6, "unit",
      "displacement where the displacing noise is 1 (its deviation is 0.3)");
    v("warp_octaves", warp_octaves, 1, 32, "1", "octaves of the displacement");
  }
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

}  // namespace verdigris
