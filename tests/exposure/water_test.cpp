#include "verdigris/exposure/water.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <numbers>

#include "solids.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/openness.hpp"
#include "verdigris/io/read_mesh.hpp"

using namespace verdigris;

namespace {

constexpr glm::dvec3 z_up{0, 0, 1};

void expect_balanced(const WaterBalance& b) {
  EXPECT_GT(b.rained, 0.0);
  EXPECT_NEAR((b.stored + b.dripped + b.drained) / b.rained, 1.0, 1e-6);
  if (b.dissolved > 0.0) {
    EXPECT_NEAR((b.deposited + b.carried_off) / b.dissolved, 1.0, 1e-6);
  }
}

void expect_never_up(const Surface& surface, const WaterPaths& paths, glm::dvec3 up) {
  const auto height = [&](std::uint32_t k) { return glm::dot(up, surface.position(paths.slots[k])); };
  for (std::uint32_t k = 0; k < paths.cells.size(); ++k) {
    const WaterPaths::Cell& cell = paths.cells[k];
    for (std::size_t j = 0; j < 4; ++j)
      if (cell.share[j] > 0.0f && cell.to[j] < WaterPaths::drained) {
        ASSERT_GT(cell.to[j], k);
        ASSERT_LT(height(cell.to[j]), height(k));
      }
    if (cell.drip_to < WaterPaths::drained) {
      ASSERT_LT(height(cell.drip_to), height(k));
    }
  }
}

TEST(Water, IsConservedAndNeverRunsUp) {
  for (const Mesh& mesh : {shapes::torus(2.0, 0.8, 24, 12), shapes::round_sphere(1.0, 3),
                           shapes::right_angle(2.0, 1.0, 1.0), shapes::random_plane(0.2, 1.0, 4)})
    for (const glm::dvec3 up : {z_up, glm::normalize(glm::dvec3(0.3, -0.7, 0.5))}) {
      const Surface surface = shapes::with_cells(mesh, 20'000);
      const WaterPaths paths = make_water_paths(surface, {.up = up, .meander = 20.0});
      expect_never_up(surface, paths, up);
      const Field<float> rain = rain_exposure(surface, {up});
      expect_balanced(run_water(surface, paths, rain, rain).balance);
    }
}

void expect_conserved_on(const std::string& file) {
  const Surface surface = shapes::with_cells(read_mesh(file), 60'000);
  const WaterPaths paths = make_water_paths(surface, {});
  expect_never_up(surface, paths, {0, 1, 0});
  const Field<float> rain(surface.slot_count(), 1.0f);
  expect_balanced(run_water(surface, paths, rain, rain).balance);
}

TEST(Water, OfTheCupIsConservedToo) {
  expect_conserved_on(VERDIGRIS_MESHES "/cup.obj");
}

TEST(Water, OfTheBunnyIsConservedToo) {
  const std::string file = VERDIGRIS_SHARED_MESHES "/stanford-bunny.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no bunny";
  expect_conserved_on(file);
}

TEST(Water, RunsAlongTheGradientWhateverTheTriangulation) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (const double heading : {0.3, 2.0, 4.4}) {
      const Surface surface = make_surface(shapes::random_plane(0.2, 1.4, seed), {.cell_size = 0.02});
      const glm::dvec3 down{std::cos(heading), std::sin(heading), 0.0};
      const glm::dvec3 from = -0.8 * down;
      Field<float> rain(surface.slot_count(), 0.0f);
      glm::dvec3 source(0.0);
      double rained = 0.0;
      shapes::each_cell(surface, [&](std::uint32_t slot) {
        if (glm::length(surface.position(slot) - from) > 0.1) return;
        rain[slot] = 1.0f;
        source += surface.position(slot);
        rained += 1.0;
      });
      source /= rained;
      // A plane that falls by 20 degrees towards `heading`, seen from its own coordinates.
      const WaterPaths paths =
          make_water_paths(surface, {.up = std::cos(0.35) * z_up - std::sin(0.35) * down});
      const WaterResult water = run_water(surface, paths, rain, {}, {.film = 0.0});
      glm::dvec3 there(0.0);
      double flow = 0.0;
      shapes::each_cell(surface, [&](std::uint32_t slot) {
        const glm::dvec3 p = surface.position(slot);
        const double along = glm::dot(p - source, down);
        if (along < 1.2 || along > 1.5) return;
        there += static_cast<double>(water.flow[slot]) * (p - source);
        flow += water.flow[slot];
      });
      ASSERT_GT(flow, 0.0);
      const double angle = std::acos(glm::dot(glm::normalize(there), down)) * 180.0 / std::numbers::pi;
      EXPECT_LT(angle, 2.0) << seed << ' ' << heading;
      EXPECT_NEAR(water.balance.drained / water.balance.rained, 1.0, 1e-3);
    }
}

TEST(Water, OnAPlaneFlowGrowsWithTheWayFromTheTop) {
  const Surface surface = make_surface(shapes::random_plane(0.2, 1.4, 9), {.cell_size = 0.02});
  const glm::dvec3 down{1, 0, 0};
  Field<float> rain(surface.slot_count(), 0.0f);
  shapes::each_cell(surface,
                    [&](std::uint32_t slot) { rain[slot] = surface.position(slot).x > -0.8 ? 1.0f : 0.0f; });
  const WaterPaths paths = make_water_paths(surface, {.up = std::cos(0.35) * z_up - std::sin(0.35) * down});
  const WaterResult water = run_water(surface, paths, rain, {}, {.film = 0.0});
  double sum = 0.0, exact = 0.0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (std::abs(p.y) > 0.4 || p.x < 0.0 || p.x > 0.8) return;
    sum += water.flow[slot];
    exact += p.x + 0.8;
  });
  EXPECT_NEAR(sum / exact, 1.0, 0.03);
}

TEST(Water, WetsASphereSymmetrically) {
  const Surface surface = shapes::with_cells(shapes::round_sphere(1.0, 5), 100'000);
  const WaterPaths paths = make_water_paths(surface, {.up = z_up});
  const WaterResult water = run_water(surface, paths, rain_exposure(surface, {z_up}));
  expect_balanced(water.balance);
  for (const double latitude : {0.5, 0.0, -0.5}) {
    std::array<double, 12> sum{}, count{};
    shapes::each_cell(surface, [&](std::uint32_t slot) {
      const glm::dvec3 p = surface.position(slot);
      if (std::abs(p.z - latitude) > 0.1) return;
      const double turn = 0.5 + std::atan2(p.y, p.x) / (2.0 * std::numbers::pi);
      const auto bin = std::min<std::size_t>(11, static_cast<std::size_t>(12.0 * turn));
      sum[bin] += water.wetness[slot];
      count[bin] += 1.0;
    });
    double mean = 0.0;
    for (std::size_t k = 0; k < 12; ++k) mean += sum[k] / count[k] / 12.0;
    for (std::size_t k = 0; k < 12; ++k)
      EXPECT_NEAR(sum[k] / count[k] / mean, 1.0, 0.05) << latitude << ' ' << k;
  }
}

TEST(Water, GathersInAGutterAndLeavesAtItsEnd) {
  // Two slopes that meet in a line along x, which falls towards +x.
  Mesh mesh;
  mesh.positions = {{0, -1, 1.2}, {2, -1, 0.8}, {0, 0, 0.2}, {2, 0, -0.2}, {0, 1, 1.2}, {2, 1, 0.8}};
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 5}, {2, 5, 4}};
  const Surface surface = shapes::with_cells(mesh, 40'000);
  const WaterPaths paths = make_water_paths(surface, {.up = z_up});
  const Field<float> rain(surface.slot_count(), 1.0f);
  const WaterResult water = run_water(surface, paths, rain, {}, {.film = 0.0});
  expect_balanced(water.balance);
  EXPECT_GT(water.balance.drained / water.balance.rained, 0.98);
  double gutter = 0.0, slope = 0.0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.x < 1.7 || p.x > 1.9) return;
    double& most = std::abs(p.y) < 0.05 ? gutter : slope;
    most = std::max(most, static_cast<double>(water.flow[slot]));
  });
  EXPECT_GT(gutter, 5.0 * slope);
}

TEST(Water, DripsFromARoofOntoTheGround) {
  // A roof that falls towards +x, 1 above the ground; its lower edge stands at x = 1.
  Mesh mesh;
  mesh.positions = {{0, -1, 1.5},  {1, -1, 1.0},  {1, 1, 1.0},  {0, 1, 1.5},
                    {-2, -2, 0.0}, {3, -2, -0.5}, {3, 2, -0.5}, {-2, 2, 0.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const Surface surface = shapes::with_cells(mesh, 40'000);
  const WaterPaths paths = make_water_paths(surface, {.up = z_up});
  Field<float> rain(surface.slot_count(), 0.0f);
  shapes::each_cell(surface,
                    [&](std::uint32_t slot) { rain[slot] = surface.position(slot).z > 0.5 ? 1.0f : 0.0f; });
  const WaterResult water = run_water(surface, paths, rain, {}, {.film = 0.0});
  expect_balanced(water.balance);
  EXPECT_NEAR(water.balance.drained / water.balance.rained, 1.0, 1e-3);
  double before = 0.0, after = 0.0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.z > 0.5) return;
    (p.x < 0.9 ? before : after) += water.flow[slot];
  });
  EXPECT_EQ(before, 0.0);
  EXPECT_GT(after, 0.0);
}

TEST(Water, LaysStainsBelowTheirSourceOnly) {
  const Surface surface = make_surface(shapes::random_plane(0.2, 1.4, 2), {.cell_size = 0.02});
  Field<float> source(surface.slot_count(), 0.0f);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    source[slot] = glm::length(surface.position(slot)) < 0.1 ? 1.0f : 0.0f;
  });
  const WaterPaths paths =
      make_water_paths(surface, {.up = std::cos(0.35) * z_up - glm::dvec3(std::sin(0.35), 0, 0)});
  const Field<float> rain(surface.slot_count(), 1.0f);
  const WaterResult water = run_water(surface, paths, rain, source, {.deposit_length = 0.5});
  expect_balanced(water.balance);
  double near = 0.0, far = 0.0;
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.x < -0.15 || std::abs(p.y) > 0.45) {
      EXPECT_LT(water.stain[slot], 1e-3f);
    }
    if (std::abs(p.x - 0.2) < 0.05) near += water.stain[slot];
    if (std::abs(p.x - 0.7) < 0.05) far += water.stain[slot];
  });
  EXPECT_NEAR(far / near, std::exp(-1.0), 0.05);
}

TEST(Water, HasTheSameBitsForAnyNumberOfThreads) {
  const Surface surface = shapes::with_cells(shapes::torus(2.0, 0.8, 24, 12), 20'000);
  const auto all = [&] {
    const WaterPaths paths = make_water_paths(surface, {.up = {0, 1, 0}, .meander = 15.0});
    const Field<float> rain = rain_exposure(surface);
    const WaterResult w = run_water(surface, paths, rain, rain);
    return std::array{w.flow, w.stored, w.wetness, w.stain};
  };
  const auto many = all();
  tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(all(), many);
}

TEST(Water, RefusesSettingsOfNoUse) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 600);
  EXPECT_THROW(make_water_paths(surface, {.up = {0, 0, 0}}), InputError);
  EXPECT_THROW(make_water_paths(surface, {.meander = 90.0}), InputError);
  const WaterPaths paths = make_water_paths(surface);
  EXPECT_THROW(run_water(surface, paths, Field<float>(3)), std::invalid_argument);
  const Field<float> rain(surface.slot_count(), 1.0f);
  EXPECT_THROW(run_water(surface, paths, rain, {}, {.film = -1.0}), InputError);
}

}  // namespace
