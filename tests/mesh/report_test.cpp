#include "verdigris/mesh/report.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

using namespace verdigris;

namespace {

MeshReport report_of(const Mesh& mesh) {
  return inspect(mesh, make_adjacency(mesh));
}

TEST(Report, OfTetrahedron) {
  const MeshReport r = report_of(shapes::tetrahedron());
  EXPECT_EQ(r.vertices, 4u);
  EXPECT_EQ(r.triangles, 4u);
  EXPECT_EQ(r.edges, 6u);
  EXPECT_EQ(r.components, 1u);
  EXPECT_TRUE(r.closed());
  EXPECT_EQ(r.boundary_loops + r.non_manifold_vertices + r.degenerate_triangles + r.duplicate_triangles, 0u);
  EXPECT_DOUBLE_EQ(r.shortest_edge, 1.0);
  EXPECT_DOUBLE_EQ(r.longest_edge, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(r.mean_edge, (1.0 + std::sqrt(2.0)) / 2.0);
  EXPECT_DOUBLE_EQ(r.smallest_height, std::sqrt(0.5));
}

TEST(Report, OfTorusHasEulerNumberZero) {
  const MeshReport r = report_of(shapes::torus(8, 6));
  EXPECT_EQ(r.vertices + r.triangles, r.edges);
  EXPECT_TRUE(r.closed());
  EXPECT_EQ(r.components, 1u);
}

TEST(Report, OfNothing) {
  const MeshReport r = report_of(Mesh{});
  EXPECT_EQ(r.edges + r.components + r.boundary_loops, 0u);
  EXPECT_EQ(r.shortest_edge + r.mean_edge + r.smallest_height, 0.0);
}

TEST(Report, CountsLoopsOfStrips) {
  EXPECT_EQ(report_of(shapes::triangle()).boundary_loops, 1u);
  EXPECT_EQ(report_of(shapes::strip(12, 0)).boundary_loops, 2u);
  const MeshReport moebius = report_of(shapes::strip(12, 1));
  EXPECT_EQ(moebius.boundary_loops, 1u);
  EXPECT_EQ(moebius.boundary_edges, 24u);
  EXPECT_EQ(moebius.inconsistent_edges, 1u);
  EXPECT_EQ(moebius.components, 1u);
  EXPECT_FALSE(moebius.closed());
}

TEST(Report, KeepsLoopsThatTouchApart) {
  // Two triangles that share a vertex: two components, two loops, one vertex with two fans.
  const MeshReport r = report_of(
      shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(r.components, 2u);
  EXPECT_EQ(r.boundary_loops, 2u);
  EXPECT_EQ(r.non_manifold_vertices, 1u);
}

TEST(Report, CountsEdgesOfThreeTrianglesOnce) {
  const MeshReport r = report_of(shapes::mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                                                 {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(r.non_manifold_edges, 1u);
  EXPECT_EQ(r.edges, 7u);
  EXPECT_EQ(r.components, 1u);
  EXPECT_EQ(r.boundary_loops, 0u);         // every chain ends at the bad edge
  EXPECT_EQ(r.non_manifold_vertices, 2u);  // its two ends, once it is cut
}

TEST(Report, FollowsTheRimThroughTurnedTriangles) {
  Mesh mesh = shapes::strip(12, 0);
  shapes::flip(mesh, 5);
  const MeshReport r = report_of(mesh);
  EXPECT_EQ(r.boundary_loops, 2u);
  EXPECT_EQ(r.inconsistent_edges, 2u);
  EXPECT_EQ(r.components, 1u);
}

TEST(Report, CountsWhatIsUselessOrTwice) {
  Mesh mesh = shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {9, 9, 9}},
                              {{0, 1, 3}, {0, 1, 2}, {1, 3, 0}, {3, 1, 0}});
  const MeshReport r = report_of(mesh);
  EXPECT_EQ(r.unused_vertices, 1u);
  EXPECT_EQ(r.degenerate_triangles, 1u);
  EXPECT_EQ(r.duplicate_triangles, 2u);
  EXPECT_DOUBLE_EQ(r.smallest_height, std::sqrt(0.5));
  EXPECT_EQ(r.bounds.upper, glm::dvec3(9.0));
}

TEST(Report, SeesSliversFarFromTheOriginAsSlivers) {
  const double far = 1e6;
  const Mesh sliver = shapes::mesh_of({{far, 0, 0}, {far + 1, 0, 0}, {far + 0.5, 1e-6, 0}}, {{0, 1, 2}});
  EXPECT_EQ(report_of(sliver).degenerate_triangles, 0u);
  EXPECT_NEAR(report_of(sliver).smallest_height, 1e-6, 1e-15);
}

TEST(Report, CountsTrianglesNarrowerThanACell) {
  const Mesh mesh =
      shapes::together(shapes::square(), shapes::mesh_of({{0, 0, 5}, {10, 0, 5}, {5, 0.1, 5}}, {{0, 1, 2}}));
  EXPECT_EQ(triangles_narrower_than(mesh, 0.05), 0u);
  EXPECT_EQ(triangles_narrower_than(mesh, 0.2), 1u);
  EXPECT_EQ(triangles_narrower_than(mesh, 0.8), 3u);
}

}  // namespace
