#include <gtest/gtest.h>

#include "model_files.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\n";
const std::string face_head = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

TEST(Ply, PropertiesInAnyOrderAndType) {
  const Mesh mesh = read(
      "p.ply",
      head +
          "property uchar red\nproperty short z\nproperty float t\nproperty int x\nproperty "
          "uchar green\nproperty double y\nproperty uchar blue\nproperty float s\nproperty "
          "uint8 alpha\nproperty list uchar float extra\n" +
          face_head +
          "255 0 0.5 0 0 0 51 0.25 255 2 7 8\n0 0 1 1 255 0 0 1 0 0\n0 0 0 0 0 1 0 0 255 1 nan\n3 0 1 2\n");
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.corner_uv[0], glm::vec2(0.25, 0.5));
  EXPECT_EQ(mesh.corner_color[0], glm::vec4(1, 0, 0.2F, 1));
  EXPECT_EQ(mesh.corner_color[1], glm::vec4(0, 1, 0, 0));
}

TEST(Ply, BinaryWithOtherElementsAndLists) {
  for (const bool big : {false, true}) {
    std::string bytes =
        std::string("ply\nformat ") + (big ? "binary_big_endian" : "binary_little_endian") +
        " 1.0\nobj_info x\nelement camera 1\nproperty list short double m\nproperty char c\n"
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty ushort red\n"
        "property ushort green\nproperty ushort blue\nelement face 1\nproperty uchar flag\n"
        "property list int ushort vertex_index\nproperty list uchar float texcoord\nend_header\n";
    bytes += number<std::int16_t>(2, big) + number(1.0, big) + number(2.0, big) + 'c';
    for (int v = 0; v < 3; ++v) {
      for (const int x : {v == 1 ? 1 : 0, v == 2 ? 1 : 0, 0}) bytes += number(static_cast<float>(x), big);
      for (const int c : {65535, 0, 13107}) bytes += number(static_cast<std::uint16_t>(c), big);
    }
    bytes += 'f' + number<std::int32_t>(3, big);
    for (const std::uint16_t v : {std::uint16_t{0}, std::uint16_t{1}, std::uint16_t{2}})
      bytes += number(v, big);
    bytes += '\6';
    for (int i = 0; i < 6; ++i) bytes += number(static_cast<float>(i), big);
    const Mesh mesh = read("b.ply", bytes);
    EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.corner_uv, (std::vector<glm::vec2>{{0, 1}, {2, 3}, {4, 5}}));
    EXPECT_EQ(mesh.corner_color[2], glm::vec4(1, 0, 0.2F, 1));
  }
}

TEST(Ply, FaceColours) {
  const Mesh mesh =
      read("f.ply", head +
                        "property float x\nproperty float y\nproperty float z\nelement face 1\n"
                        "property list uchar int vertex_indices\nproperty float red\nproperty float green\n"
                        "property float blue\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 1 0\n");
  EXPECT_EQ(mesh.corner_color[1], glm::vec4(0.5, 1, 0, 1));
}

TEST(Ply, LineEndsOfTheHeader) {
  const std::string plain = ply_binary(tetrahedron(), false), hash = mesh_hash(as_mesh(tetrahedron()));
  const std::size_t body = plain.find("end_header\n") + 11;
  std::string cr = plain.substr(0, body), crlf;
  for (const char c : cr) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  std::replace(cr.begin(), cr.end(), '\n', '\r');
  EXPECT_EQ(mesh_hash(read("cr.ply", cr + plain.substr(body))), hash);
  EXPECT_EQ(mesh_hash(read("crlf.ply", crlf + plain.substr(body))), hash);
  EXPECT_EQ(mesh_hash(read("bom.ply", "\xEF\xBB\xBF" + ply_text(tetrahedron()))), hash);
}

TEST(Ply, BrokenHeaders) {
  const std::string text = ply_text(tetrahedron());
  expect_refused("e.ply", replaced(text, "end_header\n", ""));
  expect_refused("only.ply", "ply\nformat ascii 1.0\n", "end_header");
  expect_refused("magic.ply", replaced(text, "ply\n", "pl\n"), "begin with 'ply'");
  expect_refused("format.ply", replaced(text, "ascii", "utf8"), "format");
  expect_refused("noformat.ply", replaced(text, "format ascii 1.0\n", ""), "format");
  expect_refused("type.ply", replaced(text, "double x", "quad x"), "type");
  expect_refused("list.ply", replaced(text, "list uchar", "list float"), "fraction");
  expect_refused("count.ply", replaced(text, "vertex 4", "vertex -4"));
  expect_refused("huge.ply", replaced(text, "vertex 4", "vertex 2000000000"), "too short");
  expect_refused("huge.ply", replaced(text, "vertex 4", "vertex 9000000000000000000"), "too short");
  expect_refused("huge.ply", replaced(text, "face 4", "face 2000000000"), "too short");
  expect_refused("xyz.ply", replaced(text, "double z", "double w"), "x, y, z");
  expect_refused("faces.ply", replaced(text, "vertex_indices", "vertices"), "vertex_indices");
  expect_refused("twice.ply", replaced(text, "element face 4", "element vertex 4"));
  expect_refused("bare.ply", "ply\nformat ascii 1.0\nelement vertex 5\nend_header\n", "no properties");
  expect_refused("strips.ply",
                 head +
                     "property float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
                     "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                 "tristrips");
}

TEST(Ply, BrokenBodies) {
  const std::string text = ply_text(tetrahedron()), binary = ply_binary(tetrahedron(), false);
  expect_refused(
      "cloud.ply",
      head + "property float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n",
      "no triangles");
  expect_refused("range.ply", replaced(text, "3 0 1 2\n", "3 0 1 4\n"), "range.ply:15:");
  expect_refused("range.ply", replaced(text, "3 0 1 2\n", "3 0 -1 2\n"));
  expect_refused("range.ply", replaced(text, "3 0 1 2\n", "3 0 1.5 2\n"));
  expect_refused("list.ply", replaced(text, "3 0 1 2\n", "-1 0 1 2\n"), "list");
  expect_refused("list.ply", replaced(text, "3 0 1 2\n", "2 0 1\n"), "2 corners");
  expect_refused("row.ply", replaced(text, "0 1 0\n", "0 1 0 5\n"), "more values");
  expect_refused("row.ply", replaced(text, "0 1 0\n", "0 1\n"));
  expect_refused("nan.ply", replaced(text, "0 1 0\n", "0 nan 0\n"), "not finite");
  expect_refused("more.ply", text + "3 0 1 2\n", "more after");
  expect_refused("more.ply", binary + "abc", "more after");
  EXPECT_EQ(read("padded.ply", binary + "\n").triangles.size(), 4u);
  std::string bad = binary;
  const std::size_t body = bad.find("end_header\n") + 11;
  bad.replace(body, 8, number(std::numeric_limits<double>::infinity()));
  expect_refused("inf.ply", bad, "byte");
  bad = binary;
  bad[body + 96] = '\xFF';
  expect_refused("length.ply", bad);
  // A list length of -1, read as unsigned by some, is 4 thousand million entries.
  bad = replaced(binary, "list uchar int", "list int int");
  bad.insert(bad.find("end_header\n") + 11 + 96, "\xFF\xFF\xFF");
  bad[bad.find("end_header\n") + 11 + 99] = '\xFF';
  expect_refused("minus_one.ply", bad, "-1");
}

}  // namespace
