// The same model in every format is the same mesh.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model_files.hpp"
#include "verdigris/mesh/report.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

TEST(Formats, GiveOneTetrahedron) {
  const Polygons model = tetrahedron();
  const std::string expected = mesh_hash(as_mesh(model));
  const std::vector<std::tuple<std::string, std::string, std::string>> files{
      {"t.obj", obj(model), "OBJ"},
      {"t.off", off(model), "OFF"},
      {"t.ply", ply_text(model), "PLY (text)"},
      {"le.ply", ply_binary(model, false), "PLY (binary little-endian)"},
      {"be.ply", ply_binary(model, true), "PLY (binary big-endian)"},
      {"t.stl", stl_text(model), "STL (text)"},
      {"b.stl", stl_binary(model), "STL (binary)"},
      {"t.om", om_lists(model), "OM"},
      {"t.glb", glb(gltf_parts(model)), "glTF (binary)"},
      {"t.gltf", gltf_embedded(gltf_parts(model)), "glTF"},
      {"T.OBJ", obj(model), "OBJ"},
  };
  for (const auto& [name, bytes, format] : files) {
    SCOPED_TRACE(name);
    ReadReport report;
    const Mesh mesh = read(name, bytes, &report);
    EXPECT_EQ(mesh_hash(mesh), expected);
    EXPECT_EQ(report.format, format);
    EXPECT_EQ(report.file_faces, 4u);
    EXPECT_EQ(report.polygons_triangulated, 0u);
  }
}

TEST(Formats, GiveOneCubeOfQuads) {
  const Polygons model = cube();
  const Mesh expected = read("c.obj", obj(model));
  const MeshReport report = inspect(expected, make_adjacency(expected));
  EXPECT_TRUE(report.closed());
  EXPECT_DOUBLE_EQ(report.area, 6.0);
  EXPECT_EQ(expected.triangles.size(), 12u);
  EXPECT_EQ(expected.face_of_triangle, (std::vector<std::uint32_t>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
  const std::vector<std::pair<std::string, std::string>> files{{"c.off", off(model)},
                                                               {"c.ply", ply_text(model)},
                                                               {"cl.ply", ply_binary(model, false)},
                                                               {"cb.ply", ply_binary(model, true)},
                                                               {"c.om", om_lists(model)}};
  for (const auto& [name, bytes] : files) {
    SCOPED_TRACE(name);
    ReadReport how;
    EXPECT_EQ(mesh_hash(read(name, bytes, &how)), mesh_hash(expected));
    EXPECT_EQ(how.polygons_triangulated, 6u);
  }
}

TEST(Formats, ReadWhatOpenMeshWrites) {
  const Mesh mesh = read("w.om", om_tetrahedron());
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
  EXPECT_TRUE(inspect(mesh, make_adjacency(mesh)).closed());
  double volume = 0.0;
  for (std::size_t t = 0; t < 4; ++t)
    volume += glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6.0;
  EXPECT_DOUBLE_EQ(volume, 1.0 / 6.0);
}

TEST(Formats, OmKeepsNonManifoldMeshes) {
  // Three triangles on one edge: OpenMesh copies vertices for the third, welding joins them again.
  const Polygons book{{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}},
                      {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}};
  EXPECT_EQ(mesh_hash(read("book.om", om_lists(book))), mesh_hash(as_mesh(book)));
}

TEST(Formats, AreFoundByExtension) {
  expect_refused("t.xyz", obj(tetrahedron()), "extension");
  expect_refused("t", obj(tetrahedron()), "extension");
  expect_refused("mistaken.obj", ply_text(tetrahedron()), "rename it to end in .ply");
  expect_refused("mistaken.ply", glb(gltf_parts(tetrahedron())), "rename it to end in .glb");
  expect_refused("page.obj", "<!DOCTYPE html><html><body>Not found</body></html>", "web page");
  expect_refused("page.stl", "<!DOCTYPE html><html><body>Not found</body></html>", "web page");
  expect_refused("packed.obj", std::string_view("PK\x03\x04\0\0", 6), "ZIP");
  expect_refused("pointer.ply", "version https://git-lfs.github.com/spec/v1\n", "Git LFS");
}

}  // namespace
