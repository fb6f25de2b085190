// Models that people use; skipped where they are not installed.

#include <gtest/gtest.h>

#include "model_files.hpp"
#include "verdigris/mesh/report.hpp"

using namespace verdigris;

namespace {

MeshReport report_of(const char* name, ReadReport* how = nullptr) {
  const Mesh mesh = read_mesh(std::filesystem::path(VERDIGRIS_SHARED_MESHES) / name, how);
  return inspect(mesh, make_adjacency(mesh));
}

bool missing(const char* name) {
  return !std::filesystem::exists(std::filesystem::path(VERDIGRIS_SHARED_MESHES) / name);
}

TEST(RealModels, StanfordBunny) {
  if (missing("stanford-bunny.obj")) GTEST_SKIP();
  const MeshReport r = report_of("stanford-bunny.obj");
  EXPECT_EQ(r.vertices, 35947u);
  EXPECT_EQ(r.triangles, 69451u);
  EXPECT_EQ(r.components, 1u);
  EXPECT_EQ(r.boundary_loops, 5u);  // the holes in its bottom
  EXPECT_EQ(r.non_manifold_edges + r.inconsistent_edges, 0u);
}

TEST(RealModels, Spot) {
  if (missing("spot.obj")) GTEST_SKIP();
  const MeshReport r = report_of("spot.obj");
  EXPECT_TRUE(r.closed());
  EXPECT_EQ(r.vertices - r.edges + r.triangles, 2u);  // a sphere, topologically
}

TEST(RealModels, Fandisk) {
  if (missing("fandisk.obj")) GTEST_SKIP();
  const MeshReport r = report_of("fandisk.obj");
  EXPECT_TRUE(r.closed());
  EXPECT_EQ(r.triangles, 12946u);
}

TEST(RealModels, TeapotIsWeldedAlongItsSeams) {
  if (missing("teapot.obj")) GTEST_SKIP();
  ReadReport how;
  const MeshReport r = report_of("teapot.obj", &how);
  EXPECT_GT(how.weld.vertices_welded, 0u);
  EXPECT_EQ(r.components, 4u);  // body, lid, handle, spout
}

}  // namespace
