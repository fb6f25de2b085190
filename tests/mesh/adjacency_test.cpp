#include "verdigris/mesh/adjacency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "shapes.hpp"

using namespace verdigris;

namespace {

std::ptrdiff_t count(const Adjacency& a, EdgeKind kind) {
  return std::count(a.kind.begin(), a.kind.end(), kind);
}

/// A link goes both ways, between the same two vertices in opposite direction; what is not linked has none.
void expect_consistent(const Mesh& mesh, const Adjacency& a) {
  auto ends = [&](std::uint32_t h) {
    const glm::uvec3& t = mesh.triangles[h / 3];
    return std::pair(t[static_cast<int>(h % 3)], t[static_cast<int>((h % 3 + 1) % 3)]);
  };
  ASSERT_EQ(a.opposite.size(), 3 * mesh.triangles.size());
  for (std::uint32_t h = 0; h < a.opposite.size(); ++h) {
    const std::uint32_t g = a.opposite[h];
    ASSERT_EQ(g != Adjacency::none, a.kind[h] == EdgeKind::linked);
    if (g == Adjacency::none) continue;
    ASSERT_EQ(a.opposite[g], h);
    ASSERT_EQ(ends(h).first, ends(g).second);
    ASSERT_EQ(ends(h).second, ends(g).first);
  }
}

TEST(Adjacency, OfOneTriangleIsBoundary) {
  const Adjacency a = make_adjacency(shapes::triangle());
  EXPECT_EQ(count(a, EdgeKind::boundary), 3);
  EXPECT_TRUE(make_adjacency(Mesh{}).opposite.empty());
}

TEST(Adjacency, LinksTheDiagonalOfASquare) {
  const Adjacency a =
      make_adjacency(shapes::square());  // 0 1 2, 0 2 3: half-edge 2 is 2-0, half-edge 3 is 0-2
  EXPECT_EQ(a.opposite[2], 3u);
  EXPECT_EQ(a.opposite[3], 2u);
  EXPECT_EQ(count(a, EdgeKind::linked), 2);
  EXPECT_EQ(count(a, EdgeKind::boundary), 4);
}

TEST(Adjacency, OfClosedMeshesLinksEverything) {
  for (const Mesh& mesh : {shapes::tetrahedron(), shapes::torus(9, 7)}) {
    const Adjacency a = make_adjacency(mesh);
    expect_consistent(mesh, a);
    EXPECT_EQ(count(a, EdgeKind::linked), static_cast<std::ptrdiff_t>(a.kind.size()));
  }
}

TEST(Adjacency, CutsEdgesOfThreeTriangles) {
  const Mesh book = shapes::mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                    {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const Adjacency a = make_adjacency(book);
  expect_consistent(book, a);
  EXPECT_EQ(count(a, EdgeKind::non_manifold), 3);
  EXPECT_EQ(count(a, EdgeKind::boundary), 6);
}

TEST(Adjacency, CutsEdgesThatRunTheSameWay) {
  Mesh mesh = shapes::square();
  shapes::flip(mesh, 1);
  const Adjacency a = make_adjacency(mesh);
  expect_consistent(mesh, a);
  EXPECT_EQ(count(a, EdgeKind::inconsistent), 2);
}

TEST(Adjacency, OfMoebiusStripHasOneInconsistentEdge) {
  const Mesh mesh = shapes::strip(12, 1);
  const Adjacency a = make_adjacency(mesh);
  expect_consistent(mesh, a);
  EXPECT_EQ(count(a, EdgeKind::inconsistent), 2);
}

// A hub vertex that all triangles share must not make the work grow with the square.
TEST(Adjacency, IsLinearForAHub) {
  constexpr std::uint32_t n = 300000;
  Mesh fan;
  fan.positions.resize(n + 1);
  for (std::uint32_t i = 0; i < n; ++i) fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  const auto start = std::chrono::steady_clock::now();
  const Adjacency a = make_adjacency(fan);
  EXPECT_LT(std::chrono::steady_clock::now() - start,
            std::chrono::seconds(5));  // slow builds; a square takes hours
  EXPECT_EQ(count(a, EdgeKind::linked), 2 * static_cast<std::ptrdiff_t>(n));
}

}  // namespace
