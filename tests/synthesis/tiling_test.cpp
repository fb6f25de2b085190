// Noise with a period repeats, and nothing shows where it begins anew.

#include <gtest/gtest.h>

#include "samples.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

const char* const noises[] = {"gradient",   "value",  "cellular",     "multiresolution", "fbm",
                              "turbulence", "ridged", "multifractal", "hybrid",          "warp"};

TEST(Tiling, APeriodLaterTheValuesAreTheSameToTheBit) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* name : noises)
    for (const double dimensions : {2.0, 3.0}) {
      const auto field = catalogue.find(name).create({{"period", 1.0}, {"dimensions", dimensions}}, 3);
      const PointList grid = unit_grid(64, 0.25);  // sums with 1 are exact
      const auto here = values_of(*field, grid);
      for (int axis = 0; axis < static_cast<int>(dimensions); ++axis)
        for (const double turns : {1.0, -2.0}) {
          PointList there = grid;
          for (double& v : axis == 0 ? there.x : axis == 1 ? there.y : there.z) v += turns;
          EXPECT_EQ(values_of(*field, there), here) << name << " along axis " << axis;
        }
    }
}

TEST(Tiling, OddPeriodsRepeatToRounding) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* name : noises) {
    const auto field = catalogue.find(name).create({{"period", 0.7}, {"frequency", 5.0}}, 3);
    PointList here = scattered(4096, 5.0), there = here;
    for (double& y : there.y) y += 0.7;
    const auto a = values_of(*field, here), b = values_of(*field, there);
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 2e-5) << name;
  }
}

TEST(Tiling, TheBorderIsLikeAnyOtherPlace) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  constexpr std::size_t side = 512;
  for (const char* name : noises) {
    const auto field = catalogue.find(name).create({{"period", 1.0}, {"dimensions", 2.0}}, 3);
    const auto v = values_of(*field, unit_grid(side));
    std::vector<double> jump(side);  // between columns x and x + 1
    for (std::size_t x = 0; x < side; ++x)
      for (std::size_t y = 0; y < side; ++y)
        jump[x] += std::fabs(static_cast<double>(v[y * side + (x + 1) % side] - v[y * side + x]));
    double mean = 0.0;
    for (const double j : jump) mean += j / side;
    EXPECT_LT(jump[side - 1], 2.0 * mean) << name;
    EXPECT_GT(jump[side - 1], 0.3 * mean) << name;
  }
}

TEST(Tiling, RefusesPeriodsThatHoldNoCell) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  EXPECT_THROW(catalogue.find("fbm").create({{"period", 0.1}, {"frequency", 1.0}}, 1), InputError);
  EXPECT_THROW(catalogue.find("cellular").create({{"period", 0.1}, {"frequency", 1.0}}, 1), InputError);
  EXPECT_THROW(catalogue.find("fbm").create({{"octaves", 32.0}, {"lacunarity", 8.0}}, 1), InputError);
}

}  // namespace
}  // namespace verdigris
