// Growth on a flat grid makes discs (Gobron & Chiba 1999, Fig. 10).

#include <gtest/gtest.h>

#include <cmath>

#include "growth.hpp"

using namespace growth;

namespace {

struct Disc {
  double filled = 0.0;  // share of the cells within T of the seed
  double spread = 0.0;  // standard deviation of the front's radius over directions, in T
};

Disc measure(const Surface& s, int steps, int runs) {
  const std::uint32_t seed = slot_at(s, {0, 0, 0});
  const CellRef c = s.cell(seed);
  Disc mean;
  for (int run = 1; run <= runs; ++run) {
    VoronoiGrowth growth = from_point(s, {0, 0, 0}, static_cast<std::uint64_t>(run));
    for (int t = 0; t < steps; ++t) growth.step();
    const auto labels = growth.labels();
    const auto at = [&](int x, int y) {
      const Row& row = s.rows()[s.row_begin(0) + 1 + static_cast<std::uint32_t>(c.row + y)];
      return labels[row.base + static_cast<std::uint32_t>(c.column + x)] == 0;
    };
    int inside = 0, filled = 0;
    for (int y = -steps; y <= steps; ++y)
      for (int x = -steps; x <= steps; ++x)
        if (x * x + y * y <= steps * steps) {
          ++inside;
          filled += at(x, y);
        }
    mean.filled += static_cast<double>(filled) / inside / runs;
    constexpr int directions = 720;
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < directions; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / directions;
      double radius = 0.0;
      for (double r = 0.0; r < 1.3 * steps; r += 0.1)
        if (at(static_cast<int>(std::lround(r * std::cos(angle))),
               static_cast<int>(std::lround(r * std::sin(angle)))))
          radius = r;
      sum += radius;
      squares += radius * radius;
    }
    sum /= directions;
    mean.spread += std::sqrt(squares / directions - sum * sum) / steps / runs;
  }
  return mean;
}

TEST(Disc, FillsTheIdealDisc) {
  const Surface s = make_surface(shapes::plain(260.0), {.cell_size = 1.0});
  const Disc ten = measure(s, 10, 100), seventy = measure(s, 70, 20), far = measure(s, 200, 6);
  std::printf("  T    filled  spread\n  10   %.3f   %.3f\n  70   %.3f   %.3f\n  200  %.3f   %.3f\n",
              ten.filled, ten.spread, seventy.filled, seventy.spread, far.filled, far.spread);
  EXPECT_NEAR(ten.filled, 0.945, 0.01);
  EXPECT_NEAR(ten.spread, 0.068, 0.01);
  EXPECT_NEAR(seventy.filled, 0.996, 0.01);
  EXPECT_GE(seventy.filled, 0.99);
  EXPECT_LE(seventy.spread, 0.02);
  EXPECT_NEAR(seventy.spread, 0.016, 0.01);
  EXPECT_NEAR(far.filled, 1.000, 0.01);
  EXPECT_NEAR(far.spread, 0.010, 0.003);  // a perfect circle is as wrong as a rough one
}

TEST(Disc, OtherCornerChancesAreWorse) {
  // 0.2071 is right: with 0 a lozenge grows, with 1 a square.
  const Surface s = make_surface(shapes::plain(60.0), {.cell_size = 1.0});
  const auto share = [&](double corner) {
    SimulationSetup setup{s, 1, {{slot_at(s, {0, 0, 0}), 1.0}}, {}};
    VoronoiGrowth growth(setup, {corner});
    for (int t = 0; t < 40; ++t) growth.step();
    std::size_t filled = 0;
    const auto labels = growth.labels();
    each_owned(s, [&](std::uint32_t slot) { filled += labels[slot] == 0; });
    return static_cast<double>(filled) / (40.0 * 40.0);
  };
  EXPECT_NEAR(share(0.0), 2.0, 0.1);
  EXPECT_NEAR(share(1.0), 4.0, 0.15);
  EXPECT_NEAR(share(0.2071), std::numbers::pi, 0.12);
}

}  // namespace
