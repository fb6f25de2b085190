#include "verdigris/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "shapes.hpp"

using namespace verdigris;

namespace {

/// A square whose diagonal is a texture seam: the file has six vertices.
Mesh seamed_square() {
  Mesh mesh = shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                              {{0, 1, 2}, {3, 4, 5}});
  for (int i = 0; i < 6; ++i) {
    mesh.corner_uv.push_back({i, 10 * i});
    mesh.corner_color.push_back({i, 0, 0, 1});
  }
  return mesh;
}

TEST(Weld, JoinsVerticesAtSeamsAndKeepsCornerAttributes) {
  WeldReport report;
  const Mesh mesh = weld(seamed_square(), &report);
  EXPECT_EQ(report.vertices_welded, 2u);
  EXPECT_EQ(report.collapsed_faces, 0u);
  ASSERT_EQ(mesh.positions.size(), 4u);
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
  EXPECT_EQ(mesh.vertex_of_file, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(mesh.corner_uv, seamed_square().corner_uv);
  EXPECT_EQ(mesh.corner_color, seamed_square().corner_color);
}

TEST(Weld, LeavesWeldedMeshAsItIs) {
  const Mesh before = shapes::torus(7, 5), after = weld(before);
  EXPECT_EQ(before.positions, after.positions);
  EXPECT_EQ(before.triangles, after.triangles);
  EXPECT_TRUE(after.vertex_of_file.empty());
  EXPECT_TRUE(after.face_of_triangle.empty());
}

TEST(Weld, DropsTrianglesThatCollapseWithTheirAttributes) {
  Mesh mesh =
      shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 3}, {0, 1, 2}, {2, 2, 0}});
  for (int i = 0; i < 9; ++i) mesh.corner_uv.push_back({i, i});
  WeldReport report;
  const Mesh welded = weld(mesh, &report);
  EXPECT_EQ(report.collapsed_faces, 2u);
  ASSERT_EQ(welded.triangles.size(), 1u);
  EXPECT_EQ(welded.face_of_triangle, std::vector<std::uint32_t>{1});
  EXPECT_EQ(welded.corner_uv, (std::vector<glm::vec2>{{3, 3}, {4, 4}, {5, 5}}));
}

TEST(Weld, ComposesMapsToTheFile) {
  Mesh mesh = shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}, {{0, 1, 3}, {0, 3, 2}});
  mesh.vertex_of_file = {3, 2, 1, 0};
  mesh.face_of_triangle = {7, 8};
  const Mesh welded = weld(mesh);
  EXPECT_EQ(welded.vertex_of_file, (std::vector<std::uint32_t>{1, 2, 1, 0}));
  EXPECT_EQ(welded.face_of_triangle, std::vector<std::uint32_t>{8});
}

TEST(Weld, TakesBothZerosForOnePosition) {
  const Mesh mesh =
      shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, -0.0, 0}}, {{0, 1, 2}, {3, 2, 1}});
  EXPECT_EQ(weld(mesh).positions.size(), 3u);
}

TEST(Weld, DoesNotJoinWhatIsOnlyClose) {
  const double next = std::nextafter(1.0, 2.0);
  const Mesh mesh = shapes::mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {next, 0, 0}}, {{0, 1, 2}, {0, 3, 2}});
  EXPECT_EQ(weld(mesh).positions.size(), 4u);
}

TEST(MeshHash, IsOfGeometryAlone) {
  const std::string hash = mesh_hash(shapes::tetrahedron());
  EXPECT_EQ(hash.size(), 32u);
  EXPECT_EQ(hash.find_first_not_of("0123456789abcdef"), std::string::npos);
  Mesh same = shapes::tetrahedron();
  same.positions[0] = {-0.0, 0.0, -0.0};
  same.corner_uv.resize(12);
  same.vertex_of_file = {0, 1, 2, 3, 3};
  EXPECT_EQ(mesh_hash(same), hash);
}

TEST(MeshHash, SeesEveryPart) {
  const std::string hash = mesh_hash(shapes::torus(40, 40));  // more than one block of the hash's buffer
  Mesh moved = shapes::torus(40, 40), turned = moved;
  moved.positions.back().z = std::nextafter(moved.positions.back().z, 9.0);
  shapes::flip(turned, turned.triangles.size() - 1);
  EXPECT_NE(mesh_hash(moved), hash);
  EXPECT_NE(mesh_hash(turned), hash);
  EXPECT_NE(mesh_hash(shapes::triangle()), mesh_hash(Mesh{}));
}

TEST(MeshMeasures, AreaAndBounds) {
  EXPECT_DOUBLE_EQ(mesh_area(shapes::square()), 1.0);
  EXPECT_DOUBLE_EQ(mesh_area(shapes::tetrahedron()), (3.0 + std::sqrt(3.0)) / 2.0);
  const Bounds bounds = mesh_bounds(shapes::torus(4, 4));
  EXPECT_NEAR(bounds.lower.x, -3.0, 1e-12);
  EXPECT_NEAR(bounds.upper.z, 1.0, 1e-12);
  EXPECT_EQ(mesh_bounds(Mesh{}).upper, glm::dvec3(0.0));
  EXPECT_EQ(mesh_area(Mesh{}), 0.0);
}

}  // namespace
