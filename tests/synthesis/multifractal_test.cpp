// Where multifractals are rough, and where fbm is.

#include <gtest/gtest.h>

#include <algorithm>

#include "samples.hpp"
#include "verdigris/synthesis/multifractals.hpp"

namespace verdigris {
namespace {

struct Roughness {
  double correlation;  ///< of a block's roughness with its height
  double ratio;        ///< mean roughness of the highest quarter of all blocks over that of the lowest
};

// Blocks of 16 x 16 samples; roughness is the deviation of the discrete Laplacian.
Roughness roughness_by_height(const ScalarField& field) {
  constexpr std::size_t side = 1024, block = 16;
  std::vector<double> heights, roughness;
  for (int part = 0; part < 4; ++part) {
    PointList grid = unit_grid(side);
    for (double& x : grid.x) x += 17.3 * part;
    const auto v = values_of(field, grid);
    for (std::size_t by = 0; by < side; by += block)
      for (std::size_t bx = 0; bx < side; bx += block) {
        double height = 0.0, square = 0.0;
        for (std::size_t y = by; y < by + block; ++y)
          for (std::size_t x = bx; x < bx + block; ++x) {
            const std::size_t k = y * side + x;
            height += static_cast<double>(v[k]);
            if (y == by || x == bx || y == by + block - 1 || x == bx + block - 1) continue;
            square +=
                std::pow(static_cast<double>(4 * v[k] - v[k - 1] - v[k + 1] - v[k - side] - v[k + side]), 2);
          }
        heights.push_back(height);
        roughness.push_back(std::sqrt(square));
      }
  }
  std::vector<double> sorted = heights;
  std::sort(sorted.begin(), sorted.end());
  const double low = sorted[sorted.size() / 4], high = sorted[sorted.size() * 3 / 4];
  double below = 0.0, above = 0.0;
  for (std::size_t k = 0; k < heights.size(); ++k) {
    if (heights[k] < low) below += roughness[k];
    if (heights[k] > high) above += roughness[k];
  }
  return {correlation(heights, roughness), above / below};
}

constexpr int two = 2;

TEST(Multifractal, FbmIsAsRoughAnywhere) {
  const Roughness r = roughness_by_height(*Fbm{{.dimensions = two}, {.H = 0.5}}.make(3));
  EXPECT_NEAR(r.correlation, 0.0, 0.06);
  EXPECT_NEAR(r.ratio, 1.0, 0.05);
}

TEST(Multifractal, HybridGrowsRougherWithHeight) {
  const Roughness r = roughness_by_height(*HybridMultifractal{{.dimensions = two}}.make(3));
  EXPECT_GT(r.correlation, 0.6);
  EXPECT_GT(r.ratio, 3.0);
}

TEST(Multifractal, CascadeAndRidgesGrowRougherToo) {
  const Roughness cascade = roughness_by_height(*Multifractal{{.dimensions = two}}.make(3));
  EXPECT_GT(cascade.correlation, 0.8);
  EXPECT_GT(cascade.ratio, 3.0);
  const Roughness ridges = roughness_by_height(*RidgedMultifractal{{.dimensions = two}}.make(3));
  EXPECT_GT(ridges.correlation, 0.3);
  EXPECT_GT(ridges.ratio, 1.2);
}

TEST(Multifractal, RidgesWithoutGainAreAlikeEverywhere) {
  // The sum of squared ridges has no feedback then; what is left comes from the ridges' own shape.
  RidgedMultifractal plain{{.dimensions = two}};
  const double with = roughness_by_height(*plain.make(3)).ratio;
  plain.gain = 0.0;
  EXPECT_LT(roughness_by_height(*plain.make(3)).ratio, with);
}

TEST(Multifractal, HybridStaysWithinTheSumOfItsOctaves) {
  // The clamp keeps it from growing without bound: at most the sum of a_i (1 + offset).
  const HybridMultifractal hybrid{{}, {.octaves = 16, .H = 0.25}, 0.7};
  double bound = 0.0;
  for (int i = 0; i < 16; ++i) bound += 1.7 * std::pow(hybrid.series.lacunarity, -0.25 * i);
  const auto values = values_of(*hybrid.make(1), scattered(1 << 18, 1000.0));
  EXPECT_LT(*std::max_element(values.begin(), values.end()), bound);
  EXPECT_GT(*std::min_element(values.begin(), values.end()), -0.31);
}

}  // namespace
}  // namespace verdigris
