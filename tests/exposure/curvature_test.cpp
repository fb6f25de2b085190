#include "verdigris/exposure/curvature.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "solids.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

namespace {

TEST(Curvature, OfASphereIsWithinTwoPercent) {
  const double radius = 2.0;
  const Surface surface = shapes::with_cells(shapes::round_sphere(radius, 5), 60'000);
  const Field<float> h = mean_curvature(surface, 0.2 * radius);
  shapes::each_cell(surface, [&](std::uint32_t slot) { ASSERT_NEAR(h[slot] * radius, 1.0, 0.02); });
}

TEST(Curvature, OfACylinderIsWithinTwoPercentAwayFromItsEnds) {
  const double radius = 0.5, length = 6.0;
  const Surface surface = shapes::with_cells(shapes::cylinder(radius, length, 40), 60'000);
  const Field<float> h = mean_curvature(surface, 0.1);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const double z = surface.position(slot).z;
    if (z > 0.5 && z < length - 0.5) {
      ASSERT_NEAR(h[slot] * 2.0 * radius, 1.0, 0.02);
    }
  });
}

TEST(Curvature, OfAnEdgeIsAGaussianOfTheRadius) {
  const double radius = 0.1, side = 2.0;
  const Surface surface = shapes::with_cells(shapes::cube(side), 60'000);
  const Field<float> h = mean_curvature(surface, radius);
  const double half = 0.5 * side;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    // Near the middle of one edge of the top.
    if (p.z < side - 1e-9 || std::abs(p.y - half) > 0.3 || p.x > half) return;
    const double exact = 0.25 * 3.14159265 * std::exp(-0.5 * p.x * p.x / (radius * radius)) /
                         (radius * std::sqrt(2.0 * 3.14159265));
    ASSERT_NEAR(h[slot], exact, 0.45) << p.x;  // of 3.1 at the edge
  });
}

TEST(Curvature, IsNegativeInsideAndTheMasksTellThemApart) {
  const Mesh ball = shapes::round_sphere(1.0, 4);
  const Surface outside = shapes::with_cells(ball, 10'000),
                inside = shapes::with_cells(shapes::turned_inside_out(ball), 10'000);
  const Field<float> convex = convexity(outside, 0.2), none = concavity(outside, 0.2),
                     hollow = concavity(inside, 0.2);
  shapes::each_cell(outside, [&](std::uint32_t slot) {
    ASSERT_NEAR(convex[slot], 1.0 - std::exp(-0.8), 0.02);
    ASSERT_EQ(none[slot], 0.0f);
  });
  shapes::each_cell(inside,
                    [&](std::uint32_t slot) { ASSERT_NEAR(hollow[slot], 1.0 - std::exp(-0.8), 0.02); });
}

TEST(Curvature, OfAPlaneIsNothing) {
  const Surface surface = shapes::with_cells(shapes::random_plane(0.2, 1.0, 3), 10'000);
  const Field<float> h = mean_curvature(surface, 0.1);
  for (const float v : h) ASSERT_NEAR(v, 0.0f, 1e-6f);
}

TEST(Curvature, HasTheSameBitsForAnyNumberOfThreads) {
  const Surface surface = shapes::with_cells(shapes::torus(2.0, 0.8, 24, 12), 20'000);
  const Field<float> many = mean_curvature(surface, 0.2);
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(mean_curvature(surface, 0.2), many);
}

TEST(Curvature, RefusesARadiusOfNothing) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 600);
  EXPECT_THROW(mean_curvature(surface, 0.0), InputError);
}

}  // namespace
