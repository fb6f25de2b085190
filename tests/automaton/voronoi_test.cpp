#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "growth.hpp"
#include "verdigris/base/error.hpp"

using namespace growth;

namespace {

void finish(VoronoiGrowth& growth) {
  while (!growth.finished()) growth.step();
}

TEST(Voronoi, CoversAClosedModelWithEveryLabel) {
  const Surface s = make_surface(shapes::torus(3, 1, 40, 30), {.cell_size = 0.04});
  VoronoiGrowth growth({s, 9, random_seeds(s, 64, 9), {}}, {});
  finish(growth);
  std::set<std::int32_t> seen;
  const auto labels = growth.labels(), arrivals = growth.arrivals();
  each_owned(s, [&](std::uint32_t slot) {
    EXPECT_GE(labels[slot], 0);
    EXPECT_GE(arrivals[slot], 0);
    seen.insert(labels[slot]);
  });
  EXPECT_EQ(seen.size(), 64u);
}

TEST(Voronoi, LabelsAreThoseOfTheNearestSeedOnAPlane) {
  const Surface s = make_surface(shapes::random_plane(40, 150, 3), {.cell_size = 1.0});
  const auto seeds = random_seeds(s, 20, 4);
  VoronoiGrowth growth({s, 4, seeds, {}}, {});
  finish(growth);
  const auto labels = growth.labels();
  std::size_t wrong = 0, cells = 0;
  each_owned(s, [&](std::uint32_t slot) {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < seeds.size(); ++k)
      if (glm::length(s.position(slot) - s.position(seeds[k].slot)) <
          glm::length(s.position(slot) - s.position(seeds[nearest].slot)))
        nearest = k;
    ++cells;
    wrong += labels[slot] != static_cast<std::int32_t>(nearest);
  });
  EXPECT_LT(static_cast<double>(wrong), 0.025 * static_cast<double>(cells));
}

TEST(Voronoi, TiesFavourNoLabel) {
  // Two seeds six cells apart in a row: both reach the cell between them in step 3.
  const Surface row = make_surface(shapes::plain(30), {.cell_size = 1.0});
  const CellRef c = row.cell(slot_at(row, {0, 0, 0}));
  const auto slot = [&](int x) {
    return row.rows()[row.row_begin(0) + 1 + static_cast<std::uint32_t>(c.row)].base +
           static_cast<std::uint32_t>(c.column + x);
  };
  int first = 0;
  const int runs = 400;
  for (int seed = 1; seed <= runs; ++seed) {
    VoronoiGrowth growth({row, static_cast<std::uint64_t>(seed), {{slot(-3), 1.0}, {slot(3), 1.0}}, {}}, {});
    for (int t = 0; t < 3; ++t) growth.step();
    first += growth.labels()[slot(0)] == 0;
  }
  EXPECT_GT(first, runs * 0.42);
  EXPECT_LT(first, runs * 0.58);
}

TEST(Voronoi, WeightsAreSpeeds) {
  const Surface s = make_surface(shapes::plain(200), {.cell_size = 1.0});
  VoronoiGrowth growth({s, 1, {{slot_at(s, {-90, 0, 0}), 1.0}, {slot_at(s, {90, 0, 0}), 0.5}}, {}}, {});
  for (int t = 0; t < 100; ++t) growth.step();
  const auto labels = growth.labels();
  double cells[2] = {0.0, 0.0};
  each_owned(s, [&](std::uint32_t slot) {
    if (labels[slot] >= 0) cells[labels[slot]] += 1.0;
  });
  EXPECT_NEAR(std::sqrt(cells[1] / cells[0]), 0.5, 0.01);
}

TEST(Voronoi, DoesNotCrossBarriers) {
  const Surface cube = make_surface(shapes::cube(1), {.cell_size = 0.02, .crease_angle = 45.0});
  VoronoiGrowth on_face = from_point(cube, {0.4, 0.3, 1.0}, 1);
  finish(on_face);
  const auto labels = on_face.labels();
  each_owned(cube, [&](std::uint32_t slot) { EXPECT_EQ(labels[slot] == 0, cube.position(slot).z > 0.999); });

  const Surface plain = make_surface(shapes::plain(60), {.cell_size = 1.0});
  Field<std::uint8_t> wall(plain.slot_count(), 0);
  each_owned(plain, [&](std::uint32_t slot) {
    wall[slot] = std::abs(glm::length(plain.position(slot)) - 20.0) < 1.5;
  });
  VoronoiGrowth ring({plain, 1, {{slot_at(plain, {0, 0, 0}), 1.0}}, wall}, {});
  finish(ring);
  const auto inside = ring.labels();
  each_owned(plain, [&](std::uint32_t slot) {
    const double r = glm::length(plain.position(slot));
    if (r < 18.0) {
      EXPECT_EQ(inside[slot], 0);
    }
    if (r > 18.6) {
      EXPECT_EQ(inside[slot], -1);
    }
  });
}

TEST(Voronoi, TwoComponentsAreTwoWorlds) {
  Mesh two = shapes::cube(1);
  const Mesh other = shapes::cube(1);
  for (const auto& p : other.positions) two.positions.push_back(p + glm::dvec3(3, 0, 0));
  for (const auto& t : other.triangles) two.triangles.push_back(t + 8u);
  const Surface s = make_surface(two, {.cell_size = 0.05});
  VoronoiGrowth growth = from_point(s, {0.5, 0.5, 1.0}, 1);
  finish(growth);
  const auto labels = growth.labels();
  each_owned(s, [&](std::uint32_t slot) { EXPECT_EQ(labels[slot] == 0, s.position(slot).x < 2.0); });
}

TEST(Voronoi, RefusesSeedsThatCannotBe) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.25});
  const std::uint32_t slot = slot_at(s, {0.5, 0.5, 1});
  EXPECT_THROW(VoronoiGrowth({s, 1, {}, {}}, {}), InputError);
  EXPECT_THROW(VoronoiGrowth({s, 1, {{slot, 1.0}, {slot, 1.0}}, {}}, {}), InputError);
  EXPECT_THROW(VoronoiGrowth({s, 1, {{slot, 0.0}}, {}}, {}), InputError);
  EXPECT_THROW(VoronoiGrowth({s, 1, {{slot, 1.0}}, Field<std::uint8_t>(s.slot_count(), 1)}, {}), InputError);
  EXPECT_THROW(random_seeds(s, s.owned_count() + 1, 1), InputError);
  EXPECT_EQ(random_seeds(s, s.owned_count(), 1).size(), s.owned_count());
}

TEST(Voronoi, RandomSeedsAreUniformByArea) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.01});
  int on_top = 0;
  const auto seeds = random_seeds(s, 6000, 2);
  for (const Seed& seed : seeds) on_top += s.position(seed.slot).z > 0.999;
  EXPECT_NEAR(on_top, 1000, 120);
}

// A flat square whose halves are joined through a triangle of no area, turned by some angles.
Mesh square_with_filler(double turn) {
  Mesh m{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
         {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}},
         {},
         {},
         {},
         {}};
  for (glm::dvec3& p : m.positions) {
    const glm::dvec3 q(std::cos(turn) * p.x - std::sin(turn) * p.y,
                       std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
    p = {q.x, std::cos(2 * turn) * q.y - std::sin(2 * turn) * q.z,
         std::sin(2 * turn) * q.y + std::cos(2 * turn) * q.z};
  }
  return m;
}

TEST(Voronoi, FlatSurfaceHasNoBarrier) {
  for (const double turn : {0.0, 0.3, 1.1, 2.0, 2.9, 4.0})
    for (const double angle : {0.0, 45.0}) {
      const Surface s = make_surface(square_with_filler(turn), {.cell_size = 0.02, .crease_angle = angle});
      VoronoiGrowth growth({s, 1, random_seeds(s, 1, 1), {}}, {});
      finish(growth);
      const auto labels = growth.labels();
      each_owned(s, [&](std::uint32_t slot) { ASSERT_EQ(labels[slot], 0) << turn << ", " << angle; });
    }
}

TEST(Voronoi, WithoutCornersItStillEnds) {
  // Walls that meet only at corners: what is behind them is never reached, and nobody waits for it.
  const Surface s = make_surface(shapes::plain(40), {.cell_size = 1.0});
  const std::uint32_t middle = slot_at(s, {0, 0, 0});
  Field<std::uint8_t> walls(s.slot_count(), 0);
  each_owned(s, [&](std::uint32_t slot) {
    const CellRef c = s.cell(slot);
    walls[slot] = (c.row + c.column) % 2 == 0 && slot != middle;
  });
  SimulationSetup setup{s, 1, {{middle, 1.0}}, walls};
  VoronoiGrowth growth(setup, {0.0});
  for (int step = 0; step < 10000 && !growth.finished(); ++step) growth.step();
  EXPECT_TRUE(growth.finished());
  EXPECT_LT(growth.steps(), 100u);
}

TEST(Voronoi, ProjectedPairsTakeLinearTimeWhereTrianglesAreSmallerThanCells) {
  // 57,600 triangles of about a cell each: a turn passes many of them, and visits none again and again.
  const Surface s =
      make_surface(shapes::torus(3, 1, 240, 120), {.cell_size = 0.045, .links = LinkKind::projected});
  VoronoiGrowth growth({s, 1, random_seeds(s, 5, 1), {}}, {});
  std::uint64_t changed = 0;
  while (!growth.finished()) changed += growth.step().changed;
  EXPECT_LT(changed, 20u * s.slot_count());
}

}  // namespace
