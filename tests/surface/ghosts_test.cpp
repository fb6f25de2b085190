#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "shapes.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/surface/surface.hpp"

using namespace verdigris;

namespace {

// Every slot that an owned cell can read and that is not owned.
std::set<std::uint32_t> ghosts_of(const Surface& s) {
  std::set<std::uint32_t> ghosts;
  for (std::uint32_t r = 0; r < s.rows().size(); ++r)
    for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; ++slot)
      for (int d = -1; d <= 1; ++d) {
        const Row& near = s.rows().data()[static_cast<std::ptrdiff_t>(r) + d];
        for (std::uint32_t k = 0; k < 3; ++k) {
          const std::uint32_t n = near.base + (slot - s.rows()[r].base) + k - 1;
          if (n < near.run_begin || n >= near.run_end) ghosts.insert(n);
        }
      }
  return ghosts;
}

// [ghost] -> its source; fails when a ghost has two.
std::map<std::uint32_t, std::uint32_t> sources_of(const Surface& s) {
  std::map<std::uint32_t, std::uint32_t> source;
  s.links().for_each([&](std::uint32_t from, auto targets) {
    EXPECT_TRUE(s.is_owned(from));
    for (const std::uint32_t to : targets)
      EXPECT_TRUE(source.emplace(to, from).second) << "ghost " << to << " has two owners";
  });
  return source;
}

void expect_sound(const Surface& s, const char* name) {
  const auto ghosts = ghosts_of(s);
  const auto source = sources_of(s);
  EXPECT_EQ(source.size() + s.open_ghost_count() + s.lost_ghost_count(), ghosts.size()) << name;
  EXPECT_EQ(source.size(), s.ghost_count()) << name;
  EXPECT_EQ(s.lost_ghost_count(), 0u) << name;
  std::size_t own = 0;
  for (const auto& [ghost, from] : source) {
    EXPECT_EQ(ghosts.count(ghost), 1u) << name;
    own += s.cell(ghost).patch == s.cell(from).patch;
  }
  // Only over shreds of surface that own no cell does a ghost repeat a cell of its own patch.
  EXPECT_LE(own, ghosts.size() / 10000) << name;
}

TEST(Ghosts, EveryGhostOfAClosedModelHasExactlyOneOwner) {
  for (const double h : {0.011, 0.05, 0.3}) {
    const Surface torus = make_surface(shapes::torus(3, 1, 30, 20), {.cell_size = h});
    expect_sound(torus, "torus");
    EXPECT_EQ(torus.open_ghost_count(), 0u);
    const Surface cube = make_surface(shapes::cube(3), {.cell_size = h});
    expect_sound(cube, "cube");
    EXPECT_EQ(cube.open_ghost_count(), 0u);
  }
}

TEST(Ghosts, RealModelsAreSound) {
  for (const char* name : {"spot", "fandisk", "teapot", "stanford-bunny"}) {
    const std::string file = std::string(VERDIGRIS_SHARED_MESHES) + "/" + name + ".obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << name;
    Mesh mesh = read_mesh(file);
    const double h = cell_size_for(mesh, 2e5);
    expect_sound(make_surface(std::move(mesh), {.cell_size = h}), name);
  }
}

TEST(Ghosts, AnOpenEdgeHasGhostsWithoutSource) {
  const Surface s = make_surface(shapes::square(1.0), {.cell_size = 0.05});
  EXPECT_GT(s.open_ghost_count(), 0u);
  expect_sound(s, "square");
}

TEST(Ghosts, OnAPlaneTheSourceIsTheCellUnderTheGhost) {
  // Unfolding a plane moves nothing: a ghost's centre and its source's centre are near in model space.
  const Surface s = make_surface(shapes::random_plane(12.0, 100.0, 5), {.cell_size = 1.0});
  double sum = 0.0, worst = 0.0;
  const auto source = sources_of(s);
  for (const auto& [ghost, from] : source) {
    const double distance = glm::length(s.position(ghost) - s.position(from));
    sum += distance;
    worst = std::max(worst, distance);
  }
  // The mean distance from a random point to the nearest point of a unit lattice is 0.383, the greatest
  // 0.707; where no cell of the landing triangle holds the point, the nearest of its neighbours may be a
  // little farther.
  EXPECT_LT(sum / static_cast<double>(source.size()), 0.41);
  EXPECT_LT(worst, 1.2);
}

TEST(Ghosts, WhereGridsLineUpGhostsLieOnCells) {
  // Right triangles whose hypotenuse is a whole, even number of cells long: one lattice all over the sheet.
  const double h = std::sqrt(2.0) / 8.0;
  const Surface s = make_surface(
      shapes::grid(6, 5, false, false, [](int i, int j) { return glm::dvec3(i, j, 0); }), {.cell_size = h});
  // 960 cells of area; centres on the outer boundary count in full.
  EXPECT_NEAR(static_cast<double>(s.owned_count()), 30.0 / (h * h), 100.0);
  for (const auto& [ghost, from] : sources_of(s))
    EXPECT_LT(glm::length(s.position(ghost) - s.position(from)), 1e-3 * h);
}

TEST(Ghosts, CreasesAreNotCrossed) {
  const Surface s = make_surface(shapes::cube(1.0), {.cell_size = 0.1, .crease_angle = 45.0});
  EXPECT_GT(s.open_ghost_count(), 0u);
  s.links().for_each([&](std::uint32_t from, auto targets) {
    for (const std::uint32_t to : targets)
      EXPECT_NEAR(glm::dot(s.frame(s.cell(from).patch).normal(), s.frame(s.cell(to).patch).normal()), 1.0,
                  1e-12);
  });
}

TEST(Ghosts, BadEdgesAreNotLinked) {
  // Three triangles at one edge: none of them may see another.
  Mesh fan{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0.2}, {0.5, 0, 1}},
           {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}},
           {},
           {},
           {},
           {}};
  EXPECT_EQ(make_surface(fan, {.cell_size = 0.05}).ghost_count(), 0u);
  // Two triangles that run along their edge in the same direction.
  Mesh twisted{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}}, {{0, 1, 2}, {0, 1, 3}}, {}, {}, {}, {}};
  EXPECT_EQ(make_surface(twisted, {.cell_size = 0.05}).ghost_count(), 0u);
}

TEST(Ghosts, TrianglesOfNoAreaAreWalkedThrough) {
  // A square whose halves are joined through a triangle of no area (b lies on ac).
  Mesh m{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
         {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}},
         {},
         {},
         {},
         {}};
  const Surface s = make_surface(m, {.cell_size = 0.05});
  EXPECT_EQ(s.lost_ghost_count(), 0u);
  std::size_t from_lower = 0;
  s.links().for_each(
      [&](std::uint32_t from, auto targets) { from_lower += s.cell(from).patch == 0 ? targets.size() : 0; });
  EXPECT_GT(from_lower, 20u);
}

}  // namespace
