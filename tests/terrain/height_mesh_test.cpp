// Height fields as meshes: which way they face, what they enclose.

#include "verdigris/terrain/height_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <vector>

#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/mesh/report.hpp"

namespace verdigris {
namespace {

double enclosed(const Mesh& mesh) {
  double volume = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    volume += glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6.0;
  return volume;
}

TEST(HeightMesh, FacesUp) {
  const std::vector<float> values{0, 1, 0, 2, 0, 1, 0, 3, 1, 0, 0, 2};
  const Mesh mesh = height_mesh({4, 3, 0.5, values}, 2.0);
  ASSERT_EQ(mesh.positions.size(), 12u);
  ASSERT_EQ(mesh.triangles.size(), 12u);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    EXPECT_GT(glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)).y,
              0.0);
  EXPECT_EQ(mesh.positions[7], glm::dvec3(1.5, 6.0, 0.5));
}

TEST(HeightMesh, CutsSquaresAlongTheirRidges) {
  const std::vector<float> ridge{0, 1, 1, 0.5f};  // from near left to far right
  const Mesh mesh = height_mesh({2, 2, 1.0, ridge}, 1.0);
  for (const auto& t : mesh.triangles)
    EXPECT_TRUE((t.x == 1 || t.y == 1 || t.z == 1) && (t.x == 2 || t.y == 2 || t.z == 2));
}

TEST(HeightMesh, SolidsAreClosedAndHoldWhatLiesUnderThem) {
  const std::vector<float> flat(5 * 4, 2.0f);
  const Mesh mesh = height_solid({5, 4, 1.0, flat}, 1.0, -1.0);
  const MeshReport report = inspect(mesh, make_adjacency(mesh));
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.inconsistent_edges, 0u);
  EXPECT_EQ(report.non_manifold_edges, 0u);
  EXPECT_NEAR(enclosed(mesh), 4.0 * 3.0 * 3.0, 1e-12);
}

TEST(HeightMesh, RefusesFloorsThatCutTheLand) {
  const std::vector<float> values{0.0f, 1.0f, 2.0f, 3.0f};
  for (const double base : {0.0, 1.0, std::nan("")})
    EXPECT_THROW(height_solid({2, 2, 1.0, values}, 1.0, base), std::invalid_argument) << base;
  EXPECT_THROW(height_solid({2, 2, 1.0, values}, -1.0, -3.0), std::invalid_argument);
  EXPECT_NO_THROW(height_solid({2, 2, 1.0, values}, -1.0, -3.1));
}

TEST(HeightMesh, RefusesWhatIsNoGrid) {
  const std::vector<float> values(4);
  EXPECT_THROW(height_mesh({1, 4, 1.0, values}, 1.0), std::invalid_argument);
  EXPECT_THROW(height_mesh({3, 2, 1.0, values}, 1.0), std::invalid_argument);
  EXPECT_THROW(height_mesh({65536, 65536, 1.0, {}}, 1.0), std::length_error);
}

}  // namespace
}  // namespace verdigris
