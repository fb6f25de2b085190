#include "verdigris/exposure/openness.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <numbers>

#include "solids.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

namespace {

TEST(Openness, IsOneOnASphereWhateverItsTriangles) {
  for (const int times : {1, 3, 5}) {
    const Surface surface = shapes::with_cells(shapes::round_sphere(2.0, times), 20'000);
    const Field<float> ao = ambient_occlusion(surface);
    shapes::each_cell(surface, [&](std::uint32_t slot) { ASSERT_FLOAT_EQ(ao[slot], 1.0f); });
  }
}

TEST(Openness, IsNothingInAClosedBox) {
  const Surface surface = shapes::with_cells(shapes::turned_inside_out(shapes::cube(3.0)), 10'000);
  const Field<float> ao = ambient_occlusion(surface);
  shapes::each_cell(surface, [&](std::uint32_t slot) { ASSERT_EQ(ao[slot], 0.0f); });
}

// A floor element at distance d from a wall of height h that reaches b to one side and c to the other: the
// view factor of a plane element to a rectangle square to it (Hamilton & Morgan 1952).
double hidden_by_wall(double d, double h, double b, double c) {
  d = std::max(d, 1e-9);
  const auto side = [&](double w) {
    const double s = std::sqrt(d * d + h * h);
    return (std::atan(w / d) - d / s * std::atan(w / s)) / (2.0 * std::numbers::pi);
  };
  return side(b) + side(c);
}

struct Error {
  double worst = 0.0, mean = 0.0;
};

// Of ambient occlusion with default settings on the floor, the first two triangles, against exact(position).
// Around the free ends of walls, where the exact value jumps, ten cells are left out.
template <typename Exact>
Error error_on_the_floor(const Surface& surface, std::initializer_list<glm::dvec3> ends, const Exact& exact) {
  const Field<float> ao = ambient_occlusion(surface);
  Error error;
  int count = 0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    if (surface.cell(slot).patch > 1) return;
    const glm::dvec3 p = surface.position(slot);
    for (const glm::dvec3 end : ends)
      if (glm::distance(p, end) < 10.0 * surface.cell_size()) return;
    const double off = static_cast<double>(ao[slot]) - exact(p);
    error.worst = std::max(error.worst, std::abs(off));
    error.mean += off;
    ++count;
  });
  error.mean /= count;
  return error;
}

TEST(Openness, IsWithinTwoPercentOfTheFormulaWhereTwoPlanesMeet) {
  const double half = 2.0, height = 1.0;
  for (const double cells : {10'000.0, 40'000.0, 200'000.0}) {
    const Surface surface = shapes::with_cells(shapes::right_angle(2.0, half, height), cells);
    const Error error = error_on_the_floor(surface, {{0, -half, 0}, {0, half, 0}}, [&](glm::dvec3 p) {
      return 1.0 - hidden_by_wall(p.x, height, half - p.y, half + p.y);
    });
    EXPECT_LT(error.worst, 0.02) << cells;
    EXPECT_LT(std::abs(error.mean), 0.002) << cells;
  }
}

TEST(Openness, IsWithinTwoPercentOfTheFormulaWhereThreePlanesMeet) {
  const double size = 2.0, height = 1.0;
  for (const double cells : {10'000.0, 40'000.0, 200'000.0}) {
    const Surface surface = shapes::with_cells(shapes::room_corner(size, height), cells);
    const Error error = error_on_the_floor(surface, {{0, size, 0}, {size, 0, 0}}, [&](glm::dvec3 p) {
      return 1.0 - hidden_by_wall(p.x, height, p.y, size - p.y) -
             hidden_by_wall(p.y, height, p.x, size - p.x);
    });
    EXPECT_LT(error.worst, 0.02) << cells;
    EXPECT_LT(std::abs(error.mean), 0.002) << cells;
  }
}

TEST(Openness, SkyIsOneOnTopHalfOnWallsNothingBelow) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 10'000);
  const Field<float> sky = sky_view(surface, {0, 0, 1});
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const double up = surface.frame(surface.cell(slot).patch).normal().z;
    ASSERT_NEAR(sky[slot], 0.5 + 0.5 * up, 0.02);
  });
}

TEST(Openness, RainFallsByTheCosineAndNotUnderARoof) {
  Mesh mesh = shapes::right_angle(2.0, 2.0, 1.0);
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3 p : {glm::dvec3(0, -2, 1), {1, -2, 1}, {1, 2, 1}, {0, 2, 1}})
    mesh.positions.push_back(p);
  mesh.triangles.push_back({n, n + 1, n + 2});
  mesh.triangles.push_back({n, n + 2, n + 3});
  const Surface surface = shapes::with_cells(mesh, 20'000);
  const RaySettings fine{.finest = surface.cell_size()};
  const Field<float> straight = rain_exposure(surface, {{0, 0, 1}, 0.0}, fine);
  const Field<float> slanted = rain_exposure(surface, {{1, 0, 1}, 0.0}, fine);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.z > 0.0 || std::abs(p.x - 1.0) < 0.05) return;
    ASSERT_NEAR(straight[slot], p.x < 1.0 ? 0.0 : 1.0, 1e-6) << p.x;
    if (p.x > 0.05) {
      ASSERT_NEAR(slanted[slot], std::sqrt(0.5), 1e-6) << p.x;
    }
  });
}

TEST(Openness, HasTheSameBitsForAnyNumberOfThreads) {
  const Surface surface = shapes::with_cells(shapes::torus(2.0, 0.8, 24, 12), 20'000);
  const auto all = [&] {
    return std::array{ambient_occlusion(surface), sky_view(surface), rain_exposure(surface)};
  };
  const auto many = all();
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(all(), many);
}

TEST(Openness, GhostsHoldTheirOwnersValue) {
  const Surface surface = shapes::with_cells(shapes::torus(2.0, 0.8, 24, 12), 5'000);
  const Field<float> ao = ambient_occlusion(surface);
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) ASSERT_EQ(ao[target], ao[source]);
  });
}

TEST(Openness, RefusesSettingsOfNoUse) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 600);
  EXPECT_THROW(ambient_occlusion(surface, {.rays = 3}), InputError);
  EXPECT_THROW(sky_view(surface, {0, 0, 0}), InputError);
  EXPECT_THROW(rain_exposure(surface, {{0, 0, 1}, 90.0}), InputError);
}

}  // namespace
