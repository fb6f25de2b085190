// Height maps: what part of a field they show, and that all of it fits.

#include "verdigris/synthesis/height_map.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

// The coordinates themselves, x + 100 y + 10000 z, within a window of its own.
struct Ruler final : ScalarField {
  ValueRange range() const override { return {}; }
  Window window() const override { return {{-1.0, 0.0, 0.0}, {3.0, 2.0, 1.0}}; }
  void compute(const Points& p, double, std::span<float> out) const override {
    for (std::size_t k = 0; k < p.size(); ++k)
      out[k] = static_cast<float>(p.x[k] + 100.0 * p.y[k] + 10000.0 * p.z[k]);
  }
};

TEST(HeightMap, ShowsTheWindowFromTheTop) {
  const HeightMap map = sample_heights(Ruler(), 8, 4, 0.0);
  EXPECT_EQ(map.step, 0.5);
  EXPECT_FLOAT_EQ(map.at(0, 0), -0.75f + 175.0f);
  EXPECT_FLOAT_EQ(map.at(7, 3), 2.75f + 25.0f);
  EXPECT_FLOAT_EQ(sample_heights(Ruler(), 8, 4, 0.5).at(7, 3), 2.75f + 25.0f + 5000.0f);
}

TEST(HeightMap, NeitherCutsNorDistorts) {
  // A square picture of the same window: as wide, and as much more above as below.
  const HeightMap map = sample_heights(Ruler(), 4, 4, 0.0);
  EXPECT_EQ(map.step, 1.0);
  EXPECT_FLOAT_EQ(map.at(0, 0), -0.5f + 250.0f);
  EXPECT_FLOAT_EQ(map.at(0, 3), -0.5f - 50.0f);
  EXPECT_THROW(sample_heights(Ruler(), 0, 4, 0.0), std::invalid_argument);
}

TEST(HeightMap, OfPeriodicNoiseRepeats) {
  const auto field = builtin_primitives().find("fbm").create({{"period", 1.0}}, 1);
  const HeightMap map = sample_heights(*field, 64, 64, 0.0);
  float greatest = 0.0f, across = 0.0f;
  for (int y = 0; y < 64; ++y) {
    across = std::max(across, std::abs(map.at(63, y) - map.at(0, y)));
    for (int x = 1; x < 64; ++x) greatest = std::max(greatest, std::abs(map.at(x, y) - map.at(x - 1, y)));
  }
  EXPECT_LE(across, greatest);
}

}  // namespace
}  // namespace verdigris
