// The Mandelbrot set's area, and Julia sets that are connected when c is in it.

#include "verdigris/synthesis/escape_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

TEST(EscapeTime, MandelbrotSetHasItsArea) {
  // 1.50659, by counting points (Munafo; Forstemann 2012). By symmetry half of it is enough.
  const int columns = 2600, rows = 1250;
  const double side = 2.6 / columns;
  std::vector<double> x(columns), y(columns), counts(columns);
  const EscapeOptions options{.most_iterations = 4000, .radius = 2.0};
  std::size_t inside = 0;
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < columns; ++k) {
      x[static_cast<std::size_t>(k)] = -2.05 + (k + 0.5) * side;
      y[static_cast<std::size_t>(k)] = (row + 0.5) * side;
    }
    mandelbrot_counts(x, y, options, counts);
    for (const double count : counts) inside += count >= options.most_iterations;
  }
  const double area = 2.0 * static_cast<double>(inside) * side * side;
  RecordProperty("area", std::to_string(area));
  EXPECT_NEAR(area, 1.50659, 0.01);
}

// How many pieces the points that have not escaped after `iterations` make up, joined over sides and corners.
int pieces(glm::dvec2 c, int iterations, int side) {
  const auto n = static_cast<std::size_t>(side);
  std::vector<double> x(n), y(n), counts(n);
  std::vector<char> stays(n * n);
  const EscapeOptions options{.most_iterations = iterations, .radius = 4.0};
  for (std::size_t row = 0; row < n; ++row) {
    for (std::size_t k = 0; k < n; ++k) {
      x[k] = -2.0 + 4.0 * (static_cast<double>(k) + 0.5) / side;
      y[k] = -2.0 + 4.0 * (static_cast<double>(row) + 0.5) / side;
    }
    julia_counts(x, y, c, options, counts);
    for (std::size_t k = 0; k < n; ++k) stays[row * n + k] = counts[k] >= iterations;
  }
  int found = 0;
  std::vector<std::size_t> open;
  for (std::size_t start = 0; start < n * n; ++start) {
    if (!stays[start]) continue;
    ++found;
    stays[start] = 0;
    open.push_back(start);
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      const auto row = static_cast<int>(at / n), column = static_cast<int>(at % n);
      for (int r = std::max(0, row - 1); r <= std::min(side - 1, row + 1); ++r)
        for (int k = std::max(0, column - 1); k <= std::min(side - 1, column + 1); ++k) {
          const std::size_t next = static_cast<std::size_t>(r) * n + static_cast<std::size_t>(k);
          if (!stays[next]) continue;
          stays[next] = 0;
          open.push_back(next);
        }
    }
  }
  return found;
}

TEST(EscapeTime, JuliaSetsAreConnectedWhereCIsInTheMandelbrotSet) {
  // After few iterations the filled sets still have necks that a grid resolves; they are connected if and
  // only if the critical orbit has stayed so long. The rabbit, the basilica, a Siegel disc's neighbour, the
  // circle, a point near the seahorses, ...
  const glm::dvec2 inside[] = {{-0.123, 0.745}, {-1.0, 0.0}, {0.0, 0.0},   {-0.39, 0.58},
                               {0.25, 0.0},     {-0.7, 0.1}, {-0.15, 0.8}, {0.3, 0.4}};
  const glm::dvec2 outside[] = {{0.4, 0.4},  {0.3, 0.7}, {-0.8, 0.4},  {0.5, 0.0},
                                {-1.2, 0.4}, {0.0, 1.2}, {-0.75, 0.3}, {0.45, 0.2}};
  for (const glm::dvec2& c : inside) {
    EXPECT_TRUE(in_mandelbrot_set(c, 5000)) << c.x << " " << c.y;
    EXPECT_EQ(pieces(c, 12, 1500), 1) << c.x << " " << c.y;
  }
  for (const glm::dvec2& c : outside) {
    EXPECT_FALSE(in_mandelbrot_set(c, 5000)) << c.x << " " << c.y;
    EXPECT_GT(pieces(c, 16, 1500), 1) << c.x << " " << c.y;
  }
}

TEST(EscapeTime, CountsAreContinuousAndIndependentOfCompany) {
  // Just outside on the real axis counts fall smoothly.
  const EscapeOptions options{.most_iterations = 500, .radius = 1000.0};
  std::vector<double> x, y(20000, 0.0), counts(20000), one(1);
  for (int k = 0; k < 20000; ++k) x.push_back(0.3 + 1e-4 * k);
  mandelbrot_counts(x, y, options, counts);
  for (std::size_t k = 1; k < counts.size(); ++k) {
    EXPECT_LT(counts[k], counts[k - 1]);
    EXPECT_GT(counts[k], counts[k - 1] - 0.02);
  }
  for (std::size_t k = 0; k < counts.size(); k += 997) {
    mandelbrot_counts({&x[k], 1}, {&y[k], 1}, options, one);
    EXPECT_EQ(one[0], counts[k]);
  }
  // |z| = 1 for c = 0 is the border; a point and its square are one iteration apart.
  const double r[] = {1.1, 1.21}, zero[] = {0.0, 0.0};
  double count[2];
  julia_counts(r, zero, {0.0, 0.0}, options, count);
  EXPECT_NEAR(count[0] - count[1], 1.0, 1e-9);
}

TEST(EscapeTime, FieldsAreOneInside) {
  const auto mandelbrot = builtin_primitives().find("mandelbrot").create({}, 1);
  EXPECT_FLOAT_EQ(mandelbrot->at({0, 0, 0, 0}), 1.0f);
  EXPECT_LT(mandelbrot->at({1, 1, 0, 0}), 0.5f);
  EXPECT_GE(mandelbrot->at({100, 1, 0, 0}), 0.0f);
  const auto julia = builtin_primitives().find("julia").create({{"c_x", 0.0}, {"c_y", 0.0}}, 1);
  EXPECT_FLOAT_EQ(julia->at({0.9, 0, 0, 0}), 1.0f);
  EXPECT_LT(julia->at({1.1, 0, 0, 0}), 1.0f);
}

}  // namespace
}  // namespace verdigris
