// Mean, variance, range, no bias towards the lattice, the same in every direction.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "samples.hpp"
#include "verdigris/synthesis/builtin.hpp"
#include "verdigris/synthesis/cellular_noise.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"

namespace verdigris {
namespace {

constexpr std::size_t many = 1 << 19;

// The mean of g(t) over 0..1.
template <typename Function>
double mean_over_cell(Function&& g) {
  constexpr int steps = 4096;
  double sum = 0.0;
  for (int k = 0; k < steps; ++k) sum += g((k + 0.5) / steps);
  return sum / steps;
}

// Weight of the corner at 0.
double corner_weight(double t) {
  return 1.0 - t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

TEST(NoiseStatistics, GradientNoiseHasTheMomentsOfItsGradients) {
  // Corners are independent, so variances add: 2^d corners, d axes, each with the mean square of its weight,
  // its distance and its gradient.
  const double square = mean_over_cell([](double t) { return std::pow(corner_weight(t), 2); });
  const double leaning = mean_over_cell([](double t) { return std::pow(t * corner_weight(t), 2); });
  const double gradient[] = {1.0 / 2, 2.0 / 3, 3.0 / 4}, greatest[] = {0.6608165, 1.0363539, 1.5365824};
  for (const int d : {2, 3, 4}) {
    const auto field = GradientNoise{{.dimensions = d, .frequency = 1.0}}.make(3);
    const auto values = values_of(*field, scattered(many, 4096.0));
    const double expected = std::pow(2.0, d) * d * gradient[d - 2] * leaning * std::pow(square, d - 1) /
                            std::pow(greatest[d - 2], 2);
    EXPECT_NEAR(moments(values).mean, 0.0, 0.002) << d;
    EXPECT_NEAR(moments(values).variance, expected, 0.01 * expected) << d;
  }
}

TEST(NoiseStatistics, ValueNoiseHasTheMomentsOfItsCorners) {
  // Uniform corners have variance 1/3; weights as above.
  const double square = mean_over_cell([](double t) { return std::pow(corner_weight(t), 2); });
  for (const int d : {2, 3, 4}) {
    const auto field = ValueNoise{{.dimensions = d, .frequency = 1.0}}.make(3);
    const auto values = values_of(*field, scattered(many, 4096.0));
    const double expected = std::pow(2.0 * square, d) / 3.0;
    EXPECT_NEAR(moments(values).mean, 0.0, 0.003) << d;
    EXPECT_NEAR(moments(values).variance, expected, 0.01 * expected) << d;
  }
}

TEST(NoiseStatistics, OctavesKeepTheVarianceOfOne) {
  const double one = moments(values_of(*Fbm{{}, {.octaves = 1}}.make(1), scattered(many, 4096.0))).variance;
  for (const double H : {0.2, 0.5, 1.0}) {
    const auto values = values_of(*Fbm{{}, {.octaves = 10, .H = H}}.make(1), scattered(many, 4096.0));
    EXPECT_NEAR(moments(values).mean, 0.0, 0.002);
    EXPECT_NEAR(moments(values).variance, one, 0.02 * one) << "H = " << H;
  }
}

TEST(NoiseStatistics, ValuesLieWithinTheRange) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* name : {"gradient", "value", "cellular", "multiresolution", "fbm", "turbulence", "ridged",
                           "multifractal", "hybrid", "warp"}) {
    const auto field = catalogue.find(name).create({}, 5);
    const ValueRange range = field->range();
    std::size_t outside = 0;
    for (const float v : values_of(*field, scattered(many, 1000.0)))
      outside += static_cast<std::size_t>(v < range.least || v > range.greatest);
    if (range.sure)
      EXPECT_EQ(outside, 0u) << name;
    else
      EXPECT_LT(static_cast<double>(outside), 0.004 * many) << name;
  }
}

TEST(NoiseStatistics, GradientNoiseComesNearItsBounds) {
  // The bound is met only where all corners point the same way; 2D shows it.
  const auto values = values_of(*GradientNoise{{.dimensions = 2}}.make(1), scattered(many, 4096.0));
  EXPECT_GT(*std::max_element(values.begin(), values.end()), 0.95f);
  EXPECT_LT(*std::min_element(values.begin(), values.end()), -0.95f);
}

TEST(NoiseStatistics, WholeCoordinatesAreLikeAnyOthers) {
  // Lattices are shifted by the seed: over seeds, points at whole multiples of a cell have the moments of
  // all.
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* name : {"gradient", "value", "fbm", "cellular", "ridged"}) {
    std::vector<float> whole, any;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
      const auto field = catalogue.find(name).create({{"frequency", 1.0}}, seed);
      PointList grid;
      for (int k = 0; k < 16; ++k) grid.add(97.0 * k, 31.0 * k, 53.0 * k, 71.0 * k);
      for (const float v : values_of(*field, grid)) whole.push_back(v);
      for (const float v : values_of(*field, scattered(16, 4096.0, static_cast<std::uint32_t>(seed))))
        any.push_back(v);
    }
    const Moments at = moments(whole), all = moments(any);
    EXPECT_NEAR(at.mean, all.mean, 6.0 * std::sqrt(2.0 * all.variance / 32000.0 * 2.0)) << name;
    EXPECT_NEAR(at.variance, all.variance, 0.05 * all.variance) << name;
  }
}

// Mean square of value(p + d e) - value(p), e a unit vector.
double increment(const ScalarField& field, double d, double x, double y, double z) {
  const PointList here = scattered(1 << 18, 4096.0);
  PointList there = here;
  const double scale = d / std::sqrt(x * x + y * y + z * z);
  for (std::size_t k = 0; k < here.size(); ++k)
    there.x[k] += scale * x, there.y[k] += scale * y, there.z[k] += scale * z;
  const auto a = values_of(field, here), b = values_of(field, there);
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::pow(static_cast<double>(a[k] - b[k]), 2.0);
  return sum / static_cast<double>(a.size());
}

TEST(NoiseStatistics, IncrementsAreTheSameInEveryDirection) {
  const double root = std::sqrt(3.0);
  const double directions[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},    {1, 1, 0},  {1, -1, 0},
                                  {0, 1, 1}, {1, 1, 1}, {root, 1, 0}, {1, -1, 1}, {1, 2, 0}};
  for (const bool octaves : {false, true})
    for (const char* basis : {"gradient", "value"})
      for (const int dimensions : {2, 3}) {
        const NoiseLattice lattice{.basis = basis, .dimensions = dimensions, .frequency = 1.0};
        const auto field = Fbm{lattice, {.octaves = octaves ? 8 : 1, .H = 0.5}}.make(5);
        for (const double d : {0.1, 0.25, 0.5, 1.0, 2.0}) {
          double least = 1e9, greatest = 0.0;
          for (const auto& e : directions) {
            if (dimensions == 2 && e[2] != 0.0) continue;
            const double s = increment(*field, d, e[0], e[1], e[2]);
            least = std::min(least, s), greatest = std::max(greatest, s);
          }
          EXPECT_LT(greatest / least, 1.06)
              << basis << " " << dimensions << "D, octaves " << octaves << ", d " << d;
        }
      }
}

}  // namespace
}  // namespace verdigris
