#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <glm/geometric.hpp>

#include "shapes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/mesh/report.hpp"
#include "verdigris/surface/surface.hpp"

using namespace verdigris;

namespace {

double covered(const Surface& s) {
  return static_cast<double>(s.owned_count()) * s.cell_size() * s.cell_size() / mesh_area(s.mesh());
}

// How far inside the triangle of its frame a point is, in cells: negative outside.
double inside(const Frame& f, glm::dvec2 p, double h) {
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 a = f.corner(k), d = f.corner((k + 1) % 3) - a;
    least = std::min(least, (d.x * (p.y - a.y) - d.y * (p.x - a.x)) / glm::length(d));
  }
  return least / h;
}

TEST(Surface, OwnsExactlyTheCellsWhoseCentreLiesInTheTriangle) {
  std::mt19937 engine(3);
  const auto u = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  for (int n = 0; n < 300; ++n) {
    const double h = n % 3 == 0 ? 0.3 : 0.05;
    const Surface s =
        make_surface(shapes::triangle({u(), u(), u()}, {u(), u(), u()}, {u(), u(), u()}), {.cell_size = h});
    const Frame& f = s.frame(0);
    std::size_t expected = 0;
    for (int row = 0; row * h < f.cy; ++row)
      for (int column = 0; column * h < f.ab; ++column) expected += inside(f, s.centre(row, column), h) > 0.0;
    EXPECT_EQ(s.owned_count(), expected);
    for (std::uint32_t r = s.row_begin(0); r < s.row_end(0); ++r)
      for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; ++slot) {
        const CellRef c = s.cell(slot);
        EXPECT_GT(inside(f, s.centre(c.row, c.column), h), -2e-3);
        EXPECT_TRUE(s.is_owned(slot));
        EXPECT_LT(glm::length(s.position(slot) - f.to_model(s.centre(c.row, c.column))), 1e-12);
      }
  }
}

TEST(Surface, ProjectedCellsAreThoseThatMeetTheTriangle) {
  const Surface s = make_surface(shapes::triangle({0, 0, 0}, {10.3, 0, 0}, {3.1, 6.7, 0}),
                                 {.cell_size = 1.0, .links = LinkKind::projected});
  const Frame& f = s.frame(0);
  // A square meets the triangle when one of many points of it lies inside.
  const auto meets = [&](int row, int column) {
    for (int y = 0; y <= 40; ++y)
      for (int x = 0; x <= 40; ++x)
        if (inside(f, {column + x / 40.0, row + y / 40.0}, 1.0) > 1e-6) return true;
    return false;
  };
  std::size_t active = 0, met = 0;
  for (const Row& row : s.rows()) active += row.run_end - row.run_begin;
  for (int row = -2; row < 9; ++row)
    for (int column = -2; column < 13; ++column) met += meets(row, column);
  EXPECT_EQ(active, met);
  EXPECT_LT(s.owned_count(), active);
}

TEST(Surface, CellsCoverTheAreaOfRealModels) {
  for (const auto& [name, tolerance] :
       {std::pair{"spot", 0.005}, {"fandisk", 0.005}, {"teapot", 0.005}, {"stanford-bunny", 0.01}}) {
    const std::string file = std::string(VERDIGRIS_SHARED_MESHES) + "/" + name + ".obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "needs " << name;
    Mesh mesh = read_mesh(file);
    const double h = cell_size_for(mesh, 1e6);
    for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected})
      EXPECT_NEAR(covered(make_surface(mesh, {.cell_size = h, .links = links})), 1.0, tolerance) << name;
  }
}

TEST(Surface, CellsCoverStructuredMeshesToo) {
  // Right triangles, all alike, their legs at 45 degrees to the grid: what one row misses every row misses,
  // so the error falls only with the number of cells along an edge.
  const Mesh sheet = shapes::grid(20, 20, false, false, [](int i, int j) { return glm::dvec3(i, j, 0); });
  for (const double h : {0.02, 0.023, 0.031, 0.025 / std::sqrt(2.0), std::sqrt(2.0) / 70.0})
    EXPECT_NEAR(covered(make_surface(sheet, {.cell_size = h})), 1.0, 0.5 * h * std::sqrt(2.0)) << h;
}

TEST(Surface, ManySmallTrianglesAndFewLargeOnes) {
  const Surface many =
      make_surface(shapes::torus(3, 1, 400, 250), {.cell_size = 0.01});  // 200,000 triangles, ~6 cells
  EXPECT_NEAR(covered(many), 1.0, 0.01);
  EXPECT_EQ(many.lost_ghost_count(), 0u);
  const Surface few = make_surface(shapes::cube(1.0), {.cell_size = 0.004});
  EXPECT_NEAR(covered(few), 1.0, 0.01);
}

TEST(Surface, TheSameBitsForAnyNumberOfThreads) {
  const Mesh mesh = shapes::torus(3, 1, 60, 40);
  const auto build = [&](std::size_t threads, LinkKind links) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return make_surface(mesh, {.cell_size = 0.02, .links = links});
  };
  for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected}) {
    const Surface a = build(1, links), b = build(4, links);
    ASSERT_EQ(a.slot_count(), b.slot_count());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> la, lb;
    a.links().for_each([&](std::uint32_t s, auto targets) {
      for (auto t : targets) la.emplace_back(s, t);
    });
    b.links().for_each([&](std::uint32_t s, auto targets) {
      for (auto t : targets) lb.emplace_back(s, t);
    });
    EXPECT_EQ(la, lb);
    EXPECT_TRUE(
        std::equal(a.rows().begin(), a.rows().end(), b.rows().begin(), [](const Row& x, const Row& y) {
          return x.begin == y.begin && x.run_begin == y.run_begin && x.run_end == y.run_end &&
                 x.base == y.base;
        }));
  }
}

TEST(Surface, EstimateIsNearTheTruth) {
  for (const double h : {0.02, 0.05, 0.2}) {
    const Mesh mesh = shapes::torus(3, 1, 60, 40);
    const SurfaceEstimate e = estimate_surface(mesh, h);
    const Surface s = make_surface(mesh, {.cell_size = h});
    EXPECT_NEAR(e.slots / static_cast<double>(s.slot_count()), 1.0, 0.35) << h;
    EXPECT_GT(e.bytes, 0.8 * static_cast<double>(s.bytes())) << h;
    EXPECT_LT(e.bytes, 1.35 * static_cast<double>(s.bytes())) << h;
  }
}

TEST(Surface, RefusesWhatCannotBeBuilt) {
  for (const double h : {0.0, -1.0, std::nan(""), 1.0 / 0.0})
    EXPECT_THROW(make_surface(shapes::cube(1), {.cell_size = h}), InputError);
  EXPECT_THROW(make_surface(Mesh{}, {.cell_size = 1.0}), InputError);
  EXPECT_THROW(make_surface(shapes::triangle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), {.cell_size = 1.0}),
               InputError);
  try {
    make_surface(shapes::cube(1), {.cell_size = 1e-9});
    FAIL() << "6e18 cells were accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("remedy"), std::string::npos);
  }
}

TEST(Surface, CellsLargerThanTrianglesOwnNothingButDoNotFail) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 10.0});
  EXPECT_EQ(s.owned_count(), 0u);
}

TEST(Surface, TrianglesNarrowerThanACellAreReported) {
  const Mesh wire = shapes::cylinder(0.02, 2.0, 12);
  const double side = 2.0 * 0.02 * std::sin(std::numbers::pi / 12);
  EXPECT_EQ(triangles_narrower_than(wire, 0.9 * side), 0u);
  EXPECT_EQ(triangles_narrower_than(wire, 1.1 * side), 24u);
}

}  // namespace
