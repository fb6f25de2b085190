#include "verdigris/synthesis/stretch_to_unit.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

namespace verdigris {
namespace {

TEST(StretchToUnit, IsInProportionBetweenTheEnds) {
  std::vector<float> values{-1.0f, 0.0f, 0.5f, 3.0f};
  stretch_to_unit(values, 0.0, 1.0);
  EXPECT_EQ(values, (std::vector<float>{0.0f, 0.0f, 0.5f, 1.0f}));
  stretch_to_unit(values, 1.0, 0.0);
  EXPECT_EQ(values, (std::vector<float>{1.0f, 1.0f, 0.5f, 0.0f}));
}

TEST(StretchToUnit, RefusesWhatAFloatCannotHold) {
  std::vector<float> values{0.0f, 1.0f};
  const std::pair<double, double> bad[] = {
      {1.0, 1.0}, {0.0, 1e-40}, {1e300, 0.0}, {0.0, std::numeric_limits<double>::infinity()}};
  for (const auto& [low, high] : bad)
    EXPECT_THROW(stretch_to_unit(values, low, high), std::invalid_argument) << low << ' ' << high;
  EXPECT_EQ(values, (std::vector<float>{0.0f, 1.0f}));
}

}  // namespace
}  // namespace verdigris
