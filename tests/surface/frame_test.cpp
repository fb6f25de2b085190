#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <random>

#include "verdigris/surface/frame.hpp"

using namespace verdigris;

namespace {

glm::dvec3 random_point(std::mt19937& engine) {
  const auto u = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  return {u(), u(), u()};
}

TEST(Frame, LaysTheLongestEdgeAlongTheRowsWithoutReflection) {
  std::mt19937 engine(1);
  for (int n = 0; n < 2000; ++n) {
    const glm::dvec3 p[3] = {random_point(engine), random_point(engine), random_point(engine)};
    const Frame f = make_frame(p[0], p[1], p[2]);
    EXPECT_GE(f.cx, 0.0);
    EXPECT_LE(f.cx, f.ab);
    EXPECT_GE(f.cy, 0.0);
    EXPECT_NEAR(glm::dot(f.u, f.u), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(f.v, f.v), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(f.u, f.v), 0.0, 1e-12);
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 corner = p[(f.first_corner + k) % 3];
      EXPECT_LT(glm::length(f.to_model(f.corner(k)) - corner), 1e-12);
      EXPECT_LT(glm::length(f.to_plane(corner) - f.corner(k)), 1e-12);
      EXPECT_LE(glm::length(p[(k + 1) % 3] - p[k]), f.ab * (1 + 1e-15));
    }
    // Same side as the triangle's own normal: oriented, never mirrored.
    EXPECT_GT(glm::dot(f.normal(), glm::cross(p[1] - p[0], p[2] - p[0])), 0.0);
  }
}

TEST(Frame, ATriangleOfNoAreaHasNoHeight) {
  const Frame f = make_frame({0, 0, 0}, {1, 1, 1}, {3, 3, 3});
  EXPECT_EQ(f.cy, 0.0);
  EXPECT_NEAR(f.ab, std::sqrt(27.0), 1e-12);
  EXPECT_NEAR(glm::dot(f.u, f.v), 0.0, 1e-12);
}

TEST(Frame, UnfoldingLaysTheSharedEdgeOnItself) {
  std::mt19937 engine(2);
  for (int n = 0; n < 500; ++n) {
    const glm::dvec3 a = random_point(engine), b = random_point(engine), c = random_point(engine),
                     d = random_point(engine);
    // (a, b, c) and (b, a, d) share edge ab.
    const Frame f = make_frame(a, b, c), g = make_frame(b, a, d);
    const int fe = (3 - f.first_corner) % 3, ge = (3 - g.first_corner) % 3;
    const Motion m = unfold(f, fe, g, ge);
    EXPECT_NEAR(m.c * m.c + m.s * m.s, 1.0, 1e-12);
    EXPECT_LT(glm::length(m(f.corner(fe)) - g.corner((ge + 1) % 3)), 1e-12);
    EXPECT_LT(glm::length(m(f.corner((fe + 1) % 3)) - g.corner(ge)), 1e-12);
    // The third corner comes to lie on the other side of the edge than g's own third corner.
    const glm::dvec2 p = g.corner(ge), q = g.corner((ge + 1) % 3) - p, own = g.corner((ge + 2) % 3) - p;
    const glm::dvec2 there = m(f.corner((fe + 2) % 3)) - p;
    EXPECT_LT((q.x * own.y - q.y * own.x) * (q.x * there.y - q.y * there.x), 0.0);
    // And back.
    const Motion back = unfold(g, ge, f, fe), both = then(m, back);
    EXPECT_LT(glm::length(both({0.3, 0.7}) - glm::dvec2(0.3, 0.7)), 1e-9);
  }
}

}  // namespace
