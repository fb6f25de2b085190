// Power spectra: the slope of fbm, and what the sampling limit leaves.

#include <gtest/gtest.h>

#include <memory>

#include "samples.hpp"
#include "spectrum.hpp"
#include "verdigris/synthesis/builtin.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris {
namespace {

// Least squares of log power against log frequency over `bins` bands of equal ratio from `low` to `high`
// cycles.
double slope(const RadialSpectrum& spectrum, double low, double high, int bins = 24) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (int b = 0; b < bins; ++b) {
    const double from = low * std::pow(high / low, b / double(bins)),
                 to = low * std::pow(high / low, (b + 1) / double(bins));
    double power = 0.0, waves = 0.0;
    for (auto k = static_cast<std::size_t>(std::ceil(from)); static_cast<double>(k) < to; ++k)
      power += spectrum.power[k], waves += spectrum.waves[k];
    if (waves == 0.0) continue;
    const double x = 0.5 * std::log(from * to), y = std::log(power / waves);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// Seven octaves from 4 to 256 cells a side, 1024 samples, four seeds: periodic, so no window. The fit spans
// four octaves, 8 to 128 cycles: whole ones, or the ripple of the octaves tilts it, and away from the first
// and last.
void expect_slope(const std::string& basis, int dimensions, double lacunarity) {
  for (const double H : {0.3, 0.5, 0.8}) {
    RadialSpectrum sum{std::vector<double>(1024), std::vector<double>(1024)};
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto field = Fbm{{.basis = basis, .dimensions = dimensions, .frequency = 4.0, .period = 1.0},
                             {.octaves = 7, .lacunarity = lacunarity, .H = H}}
                             .make(seed);
      const RadialSpectrum one = radial_spectrum(values_of(*field, unit_grid(1024, 0.3)), 1024);
      for (std::size_t k = 0; k < 1024; ++k) sum.power[k] += one.power[k], sum.waves[k] += one.waves[k];
    }
    const double expected = -(2.0 * H + 2.0), measured = slope(sum, 8.0, 128.0);
    std::printf("  %s noise, %dD, lacunarity %.2f, H %.1f: slope %.3f, expected %.3f\n", basis.c_str(),
                dimensions, lacunarity, H, measured, expected);
    EXPECT_NEAR(measured, expected, 0.05 * std::fabs(expected)) << "H = " << H;
  }
}

TEST(Spectrum, FbmOfTwoDimensionsFallsAsItsExponentSays) {
  expect_slope("gradient", 2, 2.0);
}
TEST(Spectrum, AnyLacunarityGivesThatSlope) {
  expect_slope("gradient", 2, 2.03);
}
TEST(Spectrum, ASectionOfThreeDimensionsHasTheSlopeOfTwo) {
  expect_slope("gradient", 3, 2.0);
}

TEST(Spectrum, OctavesBeyondTheSamplingLimitAreGone) {
  // Sampled eight times finer than the footprint says: what lies above its limit, 128 cycles, would alias.
  constexpr std::size_t side = 2048;
  const auto field =
      Fbm{{.dimensions = 2, .frequency = 4.0, .period = 1.0}, {.octaves = 8, .lacunarity = 2.0, .H = 0.3}}
          .make(2);
  const PointList grid = unit_grid(side);
  const RadialSpectrum all = radial_spectrum(values_of(*field, grid), side),
                       limited = radial_spectrum(values_of(*field, grid, 8.0 / side), side);
  const double above = all.between(129, side) / all.between(1, side),
               left = limited.between(129, side) / all.between(1, side);
  std::printf("  above the limit: %.2g of the power, with the footprint %.2g\n", above, left);
  EXPECT_GT(above, 0.02);
  EXPECT_LT(left, 2e-5);
  EXPECT_NEAR(limited.between(1, 33) / all.between(1, 33), 1.0, 0.01);  // what can be seen stays
}

TEST(Spectrum, FieldsFadeToTheirMeanAndNoFurther) {
  // With a footprint of many features nothing is left but the mean that averaging would have found.
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* name :
       {"gradient", "value", "cellular", "multiresolution", "fbm", "turbulence", "multifractal"}) {
    const auto field = catalogue.find(name).create({}, 3);
    const auto faded = values_of(*field, scattered(1000, 100.0), 1000.0);
    EXPECT_EQ(moments(faded).variance, 0.0) << name;
    const Moments m = moments(values_of(*field, scattered(1 << 17, 1000.0)));
    EXPECT_NEAR(moments(faded).mean, m.mean, 0.05 * std::sqrt(m.variance)) << name;
  }
}

}  // namespace
}  // namespace verdigris
