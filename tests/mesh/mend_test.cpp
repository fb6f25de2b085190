#include "verdigris/mesh/mend.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"
#include "verdigris/mesh/report.hpp"

using namespace verdigris;

namespace {

bool closed(const Mesh& mesh) {
  return inspect(mesh, make_adjacency(mesh)).closed();
}

TEST(Mend, LeavesSoundMeshesAlone) {
  MendReport report;
  const Mesh torus = shapes::torus(6, 5);
  EXPECT_EQ(mesh_hash(mend(torus, &report)), mesh_hash(torus));
  EXPECT_EQ(report.duplicates_removed + report.triangles_flipped + report.unorientable_components, 0u);
}

TEST(Mend, KeepsAClosedMeshThatIsInsideOutButConsistent) {
  Mesh room = shapes::tetrahedron();  // seen from inside, as a room would be
  for (std::size_t t = 0; t < 4; ++t) shapes::flip(room, t);
  EXPECT_EQ(mesh_hash(mend(room)), mesh_hash(room));
}

TEST(Mend, TurnsTheSmallerPart) {
  Mesh torus = shapes::torus(6, 5);
  const std::string sound = mesh_hash(torus);
  for (const std::size_t t : {0u, 7u, 31u}) shapes::flip(torus, t);
  MendReport report;
  EXPECT_EQ(mesh_hash(mend(torus, &report)), sound);
  EXPECT_EQ(report.triangles_flipped, 3u);
}

TEST(Mend, TurnsAClosedComponentOutward) {
  Mesh mesh = shapes::tetrahedron();
  const std::string sound = mesh_hash(mesh);
  for (std::size_t t = 0; t < 3; ++t) shapes::flip(mesh, t);  // the majority points inward
  MendReport report;
  EXPECT_EQ(mesh_hash(mend(mesh, &report)), sound);
  EXPECT_EQ(report.triangles_flipped, 3u);
}

TEST(Mend, TurnsCornerAttributesWithTheTriangle) {
  Mesh mesh = shapes::strip(6, 0);
  for (std::size_t i = 0; i < 3 * mesh.triangles.size(); ++i)
    mesh.corner_uv.push_back({mesh.triangles[i / 3][static_cast<int>(i % 3)], 0});
  shapes::flip(mesh, 4);
  std::swap(mesh.corner_uv[13], mesh.corner_uv[14]);
  const Mesh mended = mend(mesh);
  EXPECT_EQ(inspect(mended, make_adjacency(mended)).inconsistent_edges, 0u);
  for (std::size_t i = 0; i < mended.corner_uv.size(); ++i)
    EXPECT_EQ(mended.corner_uv[i].x, static_cast<float>(mended.triangles[i / 3][static_cast<int>(i % 3)]));
}

TEST(Mend, RemovesDuplicatesAndRemembersFaces) {
  Mesh mesh = shapes::tetrahedron();
  mesh.triangles.insert(mesh.triangles.begin() + 1, {2, 1, 0});
  mesh.corner_uv.resize(15);
  MendReport report;
  const Mesh mended = mend(mesh, &report);
  EXPECT_EQ(report.duplicates_removed, 1u);
  EXPECT_TRUE(closed(mended));
  EXPECT_EQ(mended.face_of_triangle, (std::vector<std::uint32_t>{0, 2, 3, 4}));
  EXPECT_EQ(mended.corner_uv.size(), 12u);
}

TEST(Mend, LeavesAMoebiusStripAndMendsWhatIsBesideIt) {
  const Mesh strip = shapes::strip(9, 1);
  Mesh torus = shapes::torus(5, 5);
  shapes::flip(torus, 3);
  MendReport report;
  const Mesh mended = mend(shapes::together(strip, torus), &report);
  EXPECT_EQ(report.unorientable_components, 1u);
  EXPECT_EQ(report.triangles_flipped, 1u);
  EXPECT_EQ(mesh_hash(mended), mesh_hash(shapes::together(strip, shapes::torus(5, 5))));
}

}  // namespace
