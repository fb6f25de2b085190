#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "shapes.hpp"
#include "verdigris/surface/surface.hpp"
#include "verdigris/surface/walk.hpp"

using namespace verdigris;

namespace {

TEST(Walk, OnAPlaneItEndsWhereTheStraightLineEnds) {
  const Surface s = make_surface(shapes::random_plane(1.0, 10.0, 2), {.cell_size = 0.1});
  const Unfolding unfolding(s.frames(), s.adjacency());
  std::mt19937 engine(4);
  const auto u = [&] { return static_cast<double>(engine()) / 4294967296.0 - 0.5; };
  int landed = 0;
  for (int n = 0; n < 1000; ++n) {
    const auto patch = static_cast<std::uint32_t>(engine() % s.patch_count());
    const Frame& f = s.frame(patch);
    const glm::dvec2 start = (f.corner(0) + f.corner(1) + f.corner(2)) / 3.0;
    const glm::dvec2 end = start + 8.0 * glm::dvec2(u(), u());
    const auto landing = unfolding.walk(patch, start, end);
    if (!landing) continue;
    ++landed;
    const Frame& g = s.frame(landing->patch);
    EXPECT_LT(glm::length(g.to_model(landing->point) - f.to_model(end)), 1e-9);
    for (int k = 0; k < 3; ++k) EXPECT_LT(beyond_edge(g, k, landing->point), 1e-9);
    EXPECT_LT(glm::length(landing->motion(end) - landing->point), 1e-9);
  }
  EXPECT_GT(landed, 500);
}

TEST(Walk, RoundACubeAndBackToTheStart) {
  // Straight across four faces: after four sides one is back.
  const Surface s = make_surface(shapes::cube(1.0), {.cell_size = 0.1});
  const Unfolding unfolding(s.frames(), s.adjacency());
  const glm::dvec3 from{0.3, 0.2, 0.0};  // face z = 0, triangle 1 (x > y)
  const Frame& f = s.frame(1);
  const glm::dvec2 start = f.to_plane(from), along = f.to_plane(from + glm::dvec3(1, 0, 0)) - start;
  const auto landing = unfolding.walk(1, start, start + 4.0 * along);
  ASSERT_TRUE(landing.has_value());
  EXPECT_LT(glm::length(s.frame(landing->patch).to_model(landing->point) - from), 1e-9);
}

TEST(Walk, StopsAtABoundary) {
  const Surface s = make_surface(shapes::square(1.0), {.cell_size = 0.1});
  const Unfolding unfolding(s.frames(), s.adjacency());
  const glm::dvec2 start = s.frame(0).to_plane({0.6, 0.3, 0});
  EXPECT_FALSE(unfolding.walk(0, start, s.frame(0).to_plane({1.2, 0.3, 0})).has_value());
  EXPECT_TRUE(unfolding.walk(0, start, s.frame(0).to_plane({0.1, 0.9, 0})).has_value());
}

}  // namespace
