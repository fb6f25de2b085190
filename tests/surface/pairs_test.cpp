#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "shapes.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/surface/surface.hpp"

using namespace verdigris;

namespace {

std::set<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const Surface& s) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  s.links().for_each([&](std::uint32_t a, auto partners) {
    for (const std::uint32_t b : partners) EXPECT_TRUE(pairs.emplace(a, b).second) << "twice";
  });
  return pairs;
}

TEST(Pairs, AreSymmetric) {
  for (const Mesh& mesh : {shapes::cube(3), shapes::torus(3, 1, 30, 20), shapes::random_plane(12, 60, 3)}) {
    const Surface s = make_surface(mesh, {.cell_size = 0.21, .links = LinkKind::projected});
    const auto pairs = pairs_of(s);
    EXPECT_FALSE(pairs.empty());
    for (const auto& [a, b] : pairs) {
      EXPECT_EQ(pairs.count({b, a}), 1u);
      EXPECT_NE(s.cell(a).patch, s.cell(b).patch);
    }
  }
}

TEST(Pairs, AreSymmetricOnModels) {
  for (const char* name : {"cup", "terrain", "cylinder"}) {
    const Mesh mesh = read_mesh(std::string(VERDIGRIS_MESHES) + "/" + name + ".obj");
    const Surface s =
        make_surface(mesh, {.cell_size = cell_size_for(mesh, 5e4), .links = LinkKind::projected});
    const auto pairs = pairs_of(s);
    EXPECT_FALSE(pairs.empty()) << name;
    for (const auto& [a, b] : pairs) ASSERT_EQ(pairs.count({b, a}), 1u) << name;
  }
}

TEST(Pairs, EachCellOnAnEdgeIsPairedWithTheNearestProjection) {
  // Two triangles on a plane, edge along x: what an edge crosses is row 0 on both sides.
  Mesh m{{{0, 0, 0}, {10, 0, 0}, {4, 6, 0}, {5, -6.5, 0}}, {{0, 1, 2}, {1, 0, 3}}, {}, {}, {}, {}};
  const Surface s = make_surface(m, {.cell_size = 1.0, .links = LinkKind::projected});
  std::size_t on_edge = 0;
  for (const auto& [a, b] : pairs_of(s)) {
    const glm::dvec3 p = s.position(a), q = s.position(b);
    EXPECT_NEAR(std::abs(p.y), 0.5, 1e-9);
    EXPECT_LE(std::abs(p.x - q.x), 0.5 + 1e-9);
    EXPECT_LT(p.y * q.y, 0.0);
    ++on_edge;
  }
  EXPECT_EQ(on_edge, 20u);  // ten cells on each side, the grids line up
}

TEST(Pairs, ABoundaryEdgeHasNone) {
  EXPECT_EQ(make_surface(shapes::triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                         {.cell_size = 0.1, .links = LinkKind::projected})
                .ghost_count(),
            0u);
}

}  // namespace
