// What turtles draw, against what is known of the curves.

#include "verdigris/synthesis/turtle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "boxes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {
namespace {

std::vector<TurtleLine> drawn(const std::string& name, int iterations) {
  const LSystem system = named_lsystem(name);
  return draw_word(rewrite(system.grammar, iterations, 1), system.turtle);
}

std::vector<TurtleLine> drawn_word(const std::string& symbols, double angle = 90.0) {
  Word word;
  word.symbols = symbols;
  TurtleSettings settings;
  settings.angle = angle;
  return draw_word(word, settings);
}

// `line` about every `spacing`.
std::vector<glm::dvec3> sampled(const TurtleLine& line, double spacing) {
  std::vector<glm::dvec3> points;
  for (std::size_t k = 1; k < line.points.size(); ++k) {
    const glm::dvec3 a = line.points[k - 1], b = line.points[k];
    const int n = static_cast<int>(glm::distance(a, b) / spacing) + 1;
    for (int j = 0; j < n; ++j) points.push_back(a + (b - a) * (static_cast<double>(j) / n));
  }
  return points;
}

TEST(Turtle, TurnsAreWhatTheirSymbolsSay) {
  // It starts looking along +y, up is +z: left is -x.
  const auto end = [](const char* symbols) { return drawn_word(symbols)[0].points.back(); };
  EXPECT_EQ(end("F"), glm::dvec3(0, 1, 0));
  EXPECT_EQ(end("+F"), glm::dvec3(-1, 0, 0));
  EXPECT_EQ(end("-F"), glm::dvec3(1, 0, 0));
  EXPECT_EQ(end("&F"), glm::dvec3(0, 0, -1));
  EXPECT_EQ(end("^F"), glm::dvec3(0, 0, 1));
  EXPECT_EQ(end("|F"), glm::dvec3(0, -1, 0));
  // Rolled left side down, left points down (-z).
  EXPECT_EQ(end("\\+F"), glm::dvec3(0, 0, -1));
  EXPECT_EQ(end("/+F"), glm::dvec3(0, 0, 1));
}

TEST(Turtle, BranchesAreLinesAndStemsGoOn) {
  const auto lines = drawn_word("F[+F]FfF");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].points.size(), 3u);  // the stem: two steps, though a branch came between
  EXPECT_EQ(lines[1].generation, 1);
  EXPECT_EQ(lines[1].points[0], glm::dvec3(0, 1, 0));
  EXPECT_EQ(lines[2].points[0], glm::dvec3(0, 3, 0));  // after a gap
  EXPECT_TRUE(drawn_word("XYZ").empty());
  EXPECT_EQ(drawn_word("F]F").size(), 1u);
}

TEST(Turtle, KochCurveHasItsLengthAndDimension) {
  const int n = 8;
  const auto lines = drawn("koch-curve", n);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].points.size(), (std::size_t{1} << (2 * n)) + 1);
  const double span = glm::distance(lines[0].points.front(), lines[0].points.back());
  EXPECT_NEAR(span, std::pow(3.0, n), 1e-6);
  // Moved off the grid of boxes, on whose lines the curve's base would lie.
  std::vector<glm::dvec3> points = sampled(lines[0], 0.5);
  for (glm::dvec3& p : points) p += glm::dvec3(0.377, 0.123, 0.0) * span;
  const double dimension =
      boxes::dimension(points, {span / 9, span / 27, span / 81, span / 243, span / 729, span / 2187});
  RecordProperty("dimension", std::to_string(dimension));
  EXPECT_NEAR(dimension, std::log(4.0) / std::log(3.0), 0.02);
}

TEST(Turtle, SnowflakeEnclosesEightFifthsOfItsTriangle) {
  const int n = 7;
  const auto lines = drawn("koch-snowflake", n);
  ASSERT_EQ(lines.size(), 1u);
  const auto& p = lines[0].points;
  EXPECT_LT(glm::distance(p.front(), p.back()), 1e-6);
  double twice = 0.0;
  for (std::size_t k = 1; k < p.size(); ++k) twice += p[k - 1].x * p[k].y - p[k].x * p[k - 1].y;
  const double side = std::pow(3.0, n);
  const double triangle = std::sqrt(3.0) / 4.0 * side * side;
  EXPECT_NEAR(std::abs(0.5 * twice) / triangle, 1.6 - 0.6 * std::pow(4.0 / 9.0, n), 1e-9);
}

TEST(Turtle, HilbertCurvesVisitEveryPointOfTheirGridOnce) {
  for (const bool cube : {false, true}) {
    const int n = cube ? 3 : 5;
    const auto lines = drawn(cube ? "hilbert-3d" : "hilbert", n);
    ASSERT_EQ(lines.size(), 1u);
    const std::size_t all = std::size_t{1} << (cube ? 3 * n : 2 * n);
    EXPECT_EQ(lines[0].points.size(), all);
    std::vector<glm::dvec3> shifted;
    for (const glm::dvec3& p : lines[0].points) shifted.push_back(p + 0.5);
    EXPECT_EQ(boxes::count(shifted, 1.0), all);
    const LineBounds bounds = line_bounds(lines);
    const double side = static_cast<double>((1 << n) - 1);
    EXPECT_NEAR(glm::distance(bounds.upper - bounds.lower, glm::dvec3(side, side, cube ? side : 0.0)), 0.0,
                1e-9);
  }
}

TEST(Turtle, DragonCrossesNoEdgeTwice) {
  const auto lines = drawn("dragon", 12);
  std::vector<glm::dvec3> middles;
  const auto& p = lines[0].points;
  for (std::size_t k = 1; k < p.size(); ++k) middles.push_back(0.5 * (p[k - 1] + p[k]) + 0.25);
  EXPECT_EQ(middles.size(), 4096u);
  EXPECT_EQ(boxes::count(middles, 0.5), 4096u);
}

TEST(Turtle, TernaryTreeHasThreeBranchesOnEachTip) {
  const LSystem tree = named_lsystem("ternary-tree");
  for (int n = 0; n < 5; ++n) {
    const Word word = rewrite(tree.grammar, n, 1);
    std::size_t segments = 0;
    for (const TurtleLine& line : draw_word(word, tree.turtle)) segments += line.points.size() - 1;
    EXPECT_EQ(segments, static_cast<std::size_t>(std::pow(4.0, n) + 0.5)) << n;
  }
  // The three stand round the stem at equal angles.
  const auto lines = drawn("ternary-tree", 1);
  ASSERT_EQ(lines.size(), 4u);
  glm::dvec3 sum(0.0);
  for (int k = 1; k < 4; ++k) sum += lines[static_cast<std::size_t>(k)].points[1] - glm::dvec3(0, 1, 0);
  EXPECT_LT(glm::distance(sum, glm::dvec3(0, 3.0 * std::cos(std::numbers::pi / 6.0), 0)), 1e-12);
}

TEST(Turtle, RefusesMeasuresThatAreNoNumbersOrHuge) {
  TurtleSettings settings;
  const auto drawn_with = [&](std::string symbols, std::vector<double> values) {
    Word word;
    word.symbols = std::move(symbols);
    word.values = std::move(values);
    for (std::uint32_t k = 1; k <= word.symbols.size(); ++k)
      word.ends.push_back(std::min(k, static_cast<std::uint32_t>(word.values.size())));
    return draw_word(word, settings);
  };
  EXPECT_EQ(drawn_with("F", {1e12}).size(), 1u);
  EXPECT_THROW(drawn_with("F", {1e13}), InputError);
  EXPECT_THROW(drawn_with("f", {std::nan("")}), InputError);
  EXPECT_THROW(drawn_with("FF", {9e11, 9e11}), InputError) << "they add up";
  EXPECT_THROW(drawn_with("!F", {1e300}), InputError);
  EXPECT_THROW(drawn_with("+F", {1e300}), InputError);
  settings.taper = 1e3;
  EXPECT_THROW(drawn_with("!!!!!F", {}), InputError);
  EXPECT_EQ(drawn_with("X+F", {1e300}).size(), 1u) << "X does nothing";
}

}  // namespace
}  // namespace verdigris
