// Midpoint displacement: sizes, tiles, how rough, and what is seen of early points.

#include "verdigris/synthesis/midpoint.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

constexpr MidpointScheme schemes[] = {MidpointScheme::midpoints, MidpointScheme::additions,
                                      MidpointScheme::squares};

HeightGrid row_of(std::vector<double> line) {
  HeightGrid grid;
  grid.side = static_cast<int>(line.size());
  grid.heights = std::move(line);
  return grid;
}

// Half the slope of the variogram over log lag: the Hurst exponent.
double roughness(const HeightGrid& grid, int rows) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const int lag : {2, 4, 8, 16, 32}) {
    double sum = 0.0;
    std::size_t count = 0;
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k + lag < grid.side; ++k, ++count)
        sum += std::pow(grid.at(k + lag, row) - grid.at(k, row), 2);
    const double x = std::log(lag), y = std::log(sum / static_cast<double>(count));
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return 0.5 * (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

TEST(Midpoint, SizesAndTiles) {
  for (const MidpointScheme scheme : schemes)
    for (int levels = 1; levels <= 6; ++levels)
      for (const bool tileable : {false, true}) {
        const HeightGrid grid =
            diamond_square({.levels = levels, .scheme = scheme, .tileable = tileable, .seed = 3});
        ASSERT_EQ(grid.side, (1 << levels) + 1);
        ASSERT_EQ(grid.heights.size(), static_cast<std::size_t>(grid.side * grid.side));
        const auto line =
            midpoint_line({.levels = levels, .scheme = scheme, .tileable = tileable, .seed = 3});
        ASSERT_EQ(line.size(), static_cast<std::size_t>(grid.side));
        bool repeats = line.front() == line.back();
        for (int k = 0; k < grid.side; ++k)
          repeats = repeats && grid.at(k, 0) == grid.at(k, grid.side - 1) &&
                    grid.at(0, k) == grid.at(grid.side - 1, k);
        EXPECT_EQ(repeats, tileable) << levels;
      }
  EXPECT_THROW(diamond_square({.levels = 13}), InputError);
  EXPECT_THROW(midpoint_line({.levels = 0}), InputError);
  EXPECT_THROW(diamond_square({.h = 1.5}), InputError);
}

// No seam in a tile: across its border it bends as it does inside.
TEST(Midpoint, TilesHaveNoSeam) {
  for (const MidpointScheme scheme : schemes) {
    double border = 0.0, inside = 0.0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const HeightGrid g = diamond_square({.levels = 7, .scheme = scheme, .tileable = true, .seed = seed});
      for (int k = 0; k < g.side; ++k) {
        border += std::pow(g.at(126, k) - 2.0 * g.at(128, k) + g.at(2, k), 2);
        inside += std::pow(g.at(62, k) - 2.0 * g.at(64, k) + g.at(66, k), 2);
      }
    }
    EXPECT_NEAR(std::log(border / inside), 0.0, 0.5);
  }
}

TEST(Midpoint, RoughnessFollowsH) {
  for (const MidpointScheme scheme : schemes) {
    double before_2d = 0.0, before_1d = 0.0;
    for (const double h : {0.3, 0.5, 0.8}) {
      double plane = 0.0, line = 0.0;
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        plane += roughness(diamond_square({.levels = 9, .h = h, .scheme = scheme, .seed = seed}), 512) / 8.0;
        line +=
            roughness(row_of(midpoint_line({.levels = 12, .h = h, .scheme = scheme, .seed = seed})), 1) / 8.0;
      }
      // Appended piece by piece: g++ 12 warns of its own operator+ (GCC bug 105651).
      std::string name("h"), value;
      name.append(std::to_string(static_cast<int>(10 * h))).append("_scheme");
      name.append(std::to_string(static_cast<int>(scheme)));
      value.append(std::to_string(plane)).append(" ").append(std::to_string(line));
      RecordProperty(name, value);
      EXPECT_NEAR(line, h, 0.06);
      EXPECT_NEAR(plane, h, 0.12);
      EXPECT_GT(plane, before_2d + 0.1);
      EXPECT_GT(line, before_1d + 0.1);
      before_2d = plane;
      before_1d = line;
    }
  }
}

// The lines of early points bend more than others; Miller's scheme keeps no early point.
TEST(Midpoint, CreasesAreSeenAndReduced) {
  double of[3] = {};
  for (int k = 0; k < 3; ++k) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
      of[k] += crease(diamond_square({.levels = 9, .h = 0.8, .scheme = schemes[k], .seed = seed})) / 8.0;
    RecordProperty(std::string("crease_scheme").append(std::to_string(k)), std::to_string(of[k]));
  }
  EXPECT_GT(of[0], 1.2);
  EXPECT_GT(of[1], 1.2);
  EXPECT_NEAR(of[2], 1.0, 0.03);
}

TEST(Midpoint, SameBitsForAnyNumberOfThreads) {
  for (const MidpointScheme scheme : schemes) {
    const MidpointOptions options{.levels = 8, .scheme = scheme, .seed = 11};
    const HeightGrid many = diamond_square(options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(diamond_square(options).heights, many.heights);
    MidpointOptions other = options;
    other.seed = 12;
    EXPECT_NE(diamond_square(other).heights, many.heights);
  }
}

TEST(Midpoint, FieldsAreSmoothAndPassThroughTheGrid) {
  const auto field =
      builtin_primitives().find("diamond-square").create({{"levels", 4.0}, {"tileable", 1.0}}, 5);
  const HeightGrid grid = diamond_square({.levels = 4, .tileable = true, .seed = 5});
  double low = grid.heights[0], high = low;
  for (const double z : grid.heights) low = std::min(low, z), high = std::max(high, z);
  for (const int row : {0, 3, 16})
    for (const int column : {0, 7, 16}) {
      EXPECT_NEAR(field->at({column / 16.0, row / 16.0, 0, 0}), (grid.at(column, row) - low) / (high - low),
                  1e-6);
      EXPECT_NEAR(field->at({column / 16.0 + 3.0, row / 16.0 - 2.0, 0, 0}),
                  (grid.at(column, row) - low) / (high - low), 1e-6);
    }
  // A continuous slope: on both sides of a grid line alike.
  const double e = 1e-4;
  for (int k = 1; k < 16; ++k) {
    const double x = k / 16.0, y = 0.3;
    const double here = field->at({x, y, 0, 0});
    EXPECT_NEAR((field->at({x + e, y, 0, 0}) - here) / e, (here - field->at({x - e, y, 0, 0})) / e, 0.1);
  }
  // Wide footprints smooth.
  double fine = 0.0, coarse = 0.0;
  for (int k = 0; k < 64; ++k) {
    fine += std::abs(field->at({(k + 1) / 64.0, 0.4, 0, 0}) - field->at({k / 64.0, 0.4, 0, 0}));
    coarse += std::abs(field->at({(k + 1) / 64.0, 0.4, 0, 0}, 0.25) - field->at({k / 64.0, 0.4, 0, 0}, 0.25));
  }
  EXPECT_LT(coarse, 0.7 * fine);
}

}  // namespace
}  // namespace verdigris
