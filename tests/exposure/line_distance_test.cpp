#include "verdigris/exposure/line_distance.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "solids.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

namespace {

TEST(LineDistance, IsExactOnAPlaneWhateverTheTriangulation) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Surface surface = make_surface(shapes::random_plane(0.3, 1.5, seed), {.cell_size = 0.02});
    const PaintedLine point{{0.1, -0.2, 0.0}};
    const Field<float> distance = line_distance(surface, {&point, 1});
    shapes::each_cell(surface, [&](std::uint32_t slot) {
      const double exact = glm::length(surface.position(slot) - point[0]);
      if (exact < 1.2) {
        ASSERT_NEAR(distance[slot], exact, 0.002 + 0.002 * exact);
      }
    });
  }
}

TEST(LineDistance, OfALineIsThatToItsNearestPoint) {
  const Surface surface = make_surface(shapes::random_plane(0.3, 1.5, 7), {.cell_size = 0.02});
  const PaintedLine line{{-0.5, 0, 0}, {0.5, 0, 0}};
  const Field<float> distance = line_distance(surface, {&line, 1}, 0.4);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    const double exact = std::hypot(std::max(0.0, std::abs(p.x) - 0.5), p.y);
    ASSERT_NEAR(distance[slot], std::min(exact, 0.4), 0.008) << p.x << ' ' << p.y;
  });
}

TEST(LineDistance, RunsRoundASphere) {
  const Surface surface = shapes::with_cells(shapes::round_sphere(1.0, 5), 50'000);
  const PaintedLine pole{{0, 0, 1}};
  const Field<float> distance = line_distance(surface, {&pole, 1});
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const double exact = std::acos(std::clamp(glm::normalize(surface.position(slot)).z, -1.0, 1.0));
    ASSERT_NEAR(distance[slot], exact, 0.01 + 0.01 * exact);
  });
}

TEST(LineDistance, RunsRoundTheEndOfASlit) {
  // A square of four with a slit from its middle to one side: two rows of squares joined at x < 0 only.
  Mesh mesh = shapes::grid(40, 40, false, false,
                           [](int i, int j) { return glm::dvec3(0.05 * i - 1.0, 0.05 * j - 1.0, 0.0); });
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::uint32_t i = 0; i < 20; ++i) mesh.positions.push_back(mesh.positions[20 * 41 + 21 + i]);
  for (std::size_t t = 2 * 20 * 40; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      std::uint32_t& v = mesh.triangles[t][k];
      if (v >= 20 * 41 + 21 && v < 21 * 41) v = n + v - (20 * 41 + 21);
    }
  const Surface surface = make_surface(mesh, {.cell_size = 0.01});
  const PaintedLine point{{0.5, -0.3, 0.0}};
  const Field<float> distance = line_distance(surface, {&point, 1});
  double worst = 0.0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.y < 0.02) return;
    const double cross = 0.5 + (p.x - 0.5) * 0.3 / (p.y + 0.3);  // where the straight line meets y = 0
    const double exact =
        cross < 0.0 ? glm::length(p - point[0]) : std::hypot(0.5, 0.3) + std::hypot(p.x, p.y);
    worst = std::max(worst, std::abs(distance[slot] - exact) / exact);
  });
  EXPECT_LT(worst, 0.1);
}

TEST(LineDistance, LinesAreReadStrictly) {
  const auto lines = parse_lines("0 0 0, 1 0 0; 2 2 2", "lines");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0][1], glm::dvec3(1, 0, 0));
  EXPECT_EQ(lines[1][0], glm::dvec3(2, 2, 2));
  for (const char* bad : {"", ";", "1 2", "1 2 3 4", "1 2 3 / 4 5 6", "a b c"})
    EXPECT_THROW(parse_lines(bad, "lines"), InputError) << bad;
  try {
    parse_lines("1 2 3, 4 x 5", "lines");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(e.where(), "lines, column 10");
  }
}

}  // namespace
