#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "shapes.hpp"
#include "verdigris/surface/surface.hpp"
#include "verdigris/surface/surface_point.hpp"

using namespace verdigris;

namespace {

TEST(Locate, FindsTheCellUnderAPointOfTheSurface) {
  const Surface s = make_surface(shapes::torus(3, 1, 40, 30), {.cell_size = 0.05});
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> slots;
  for (std::uint32_t r = 0; r < s.rows().size(); r += 7)
    if (s.owned(r).begin < s.owned(r).end) {
      slots.push_back(s.owned(r).begin);
      points.push_back(s.position(slots.back()));
    }
  const auto found = locate(s, points);
  for (std::size_t k = 0; k < points.size(); ++k) {
    EXPECT_EQ(found[k].slot, slots[k]);
    EXPECT_LT(found[k].distance, 1e-9);
  }
}

TEST(Locate, MovesAPointToTheNearestSurface) {
  const Surface s = make_surface(shapes::cube(1.0), {.cell_size = 0.1});
  const std::vector<glm::dvec3> points{{0.42, 0.57, 3.0}, {-2.0, 0.31, 0.52}};
  const auto found = locate(s, points);
  EXPECT_NEAR(found[0].distance, 2.0, 1e-9);
  EXPECT_NEAR(found[1].distance, 2.0, 1e-9);
  EXPECT_LT(glm::length(s.position(found[0].slot) - glm::dvec3(0.42, 0.57, 1.0)), 0.1);
  EXPECT_LT(glm::length(s.position(found[1].slot) - glm::dvec3(0.0, 0.31, 0.52)), 0.1);
}

TEST(Locate, FarFromTheOriginToo) {
  // Map coordinates: single precision would be off by metres.
  Mesh mesh = shapes::torus(3, 1, 40, 30);
  for (auto& p : mesh.positions) p += glm::dvec3(5e5, 4.6e6, 100.0);
  const Surface s = make_surface(mesh, {.cell_size = 0.05});
  const std::uint32_t slot = s.owned(s.row_begin(17) + 1).begin;
  const glm::dvec3 p = s.position(slot);
  EXPECT_EQ(locate(s, std::span(&p, 1))[0].slot, slot);
}

TEST(Locate, ReachesPastTrianglesThatOwnNoCell) {
  // A cap of tiny triangles around a vertex on an otherwise coarse sheet.
  const Mesh m = shapes::grid(60, 3, false, false, [](int i, int j) {
    return glm::dvec3(i < 40 ? 0.01 * i : 0.4 + (i - 40), j * (i < 40 ? 0.01 : 1.0), 0.0);
  });
  const Surface s = make_surface(m, {.cell_size = 0.5});
  const glm::dvec3 p{0.05, 0.01, 0.0};
  EXPECT_TRUE(s.is_owned(locate(s, std::span(&p, 1))[0].slot));
}

TEST(NearestPoint, IsNotLostToTrianglesWithoutArea) {
  // The first has two corners in one place, and `p` is beside it.
  Mesh m = shapes::square(1.0);
  m.triangles.insert(m.triangles.begin(), {0, 0, 1});
  const Surface s = make_surface(m, {.cell_size = 0.1});
  const SurfacePoint at = nearest_point(s, {0.5, 0.25, 0.5});
  EXPECT_LT(glm::distance(s.frame(at.triangle).to_model(at.point), glm::dvec3(0.5, 0.25, 0.0)), 1e-12);
}

}  // namespace
