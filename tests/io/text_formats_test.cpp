// What OBJ, OFF, PLY and STL files in the wild contain, and what broken ones do.

#include <gtest/gtest.h>

#include "model_files.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(Obj, LineEndsMarksAndContinuations) {
  const std::string plain = obj(tetrahedron()), hash = mesh_hash(as_mesh(tetrahedron()));
  std::string cr = plain, crlf;
  std::replace(cr.begin(), cr.end(), '\n', '\r');
  for (const char c : plain) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(mesh_hash(read("cr.obj", cr)), hash);
  EXPECT_EQ(mesh_hash(read("crlf.obj", crlf)), hash);
  EXPECT_EQ(mesh_hash(read("bom.obj", "\xEF\xBB\xBF" + replaced(plain, "# made by a test\n", ""))), hash);
  EXPECT_EQ(mesh_hash(read("continued.obj", replaced(plain, "f 1 2 3", "f 1 \\\n2 \\\r\n 3"))), hash);
  EXPECT_EQ(mesh_hash(read("path.obj", "# C:\\models\\\n" + plain)), hash);
  EXPECT_EQ(mesh_hash(read("no_last_line_end.obj", plain.substr(0, plain.size() - 1))), hash);
  EXPECT_EQ(mesh_hash(read("tabs.obj", replaced(plain, "f 1 2 3", "\tf\t1  2 3 # three"))), hash);
}

TEST(Obj, KeywordsThatDoNotMatterAreIgnored) {
  const Mesh mesh =
      read("k.obj", "mtllib a.mtl\no thing\ng a b\n" + corners +
                        "vn 0 0 1\nusemtl red\ns off\nl 1 2\np 1\nf 1//1 2//1 3//1\nunknown 1 2\n");
  EXPECT_EQ(mesh.triangles.size(), 1u);
}

TEST(Obj, CornersOfEveryForm) {
  const std::string head = corners + "vt 0 0\nvt 1 0\nvt 0.5 1 0\nvn 0 0 1\n";
  for (const char* face : {"f 1 2 3", "f 1/1 2/2 3/3", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/3/1",
                           "f -3 -2 -1", "f -3/-3/-1 -2/-2/-1 -1/-1/-1", "f 1/ 2/ 3/", "f 1// 2// 3//"}) {
    SCOPED_TRACE(face);
    EXPECT_EQ(read("form.obj", head + face).triangles, std::vector<glm::uvec3>{glm::uvec3(0, 1, 2)});
  }
  EXPECT_EQ(read("uv.obj", head + "f 1/1 2/2 3/3").corner_uv,
            (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0.5, 1}}));
  for (const char* face :
       {"f 1/1/1/1 2 3", "f a 2 3", "f 1.5 2 3", "f 0 1 2", "f /1 2 3", "f 1,2,3", "f 1 2x 3", "f -"})
    expect_refused("form.obj", head + face);
}

TEST(Obj, NegativeIndicesCountFromWhereTheyStand) {
  const Mesh mesh = read("n.obj", corners + "f -3 -2 -1\nv 0 0 1\nf -4 -1 -2\n");
  EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 3, 2));
  EXPECT_EQ(read("forward.obj", "f 1 2 3\n" + corners).triangles.size(), 1u);
}

TEST(Obj, ColoursOfVertices) {
  const Mesh mesh = read("c.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.corner_color, (std::vector<glm::vec4>{{1, 0, 0, 1}, {0, 1, 0, 1}, {1, 1, 1, 1}}));
  const Mesh bytes = read("c255.obj", "v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(bytes.corner_color[1], glm::vec4(0, 0.2F, 0, 1));
  EXPECT_TRUE(read("w.obj", "v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").corner_color.empty());
}

TEST(Obj, BadNumbersAreNamedWithTheirLine) {
  for (const char* bad :
       {"nan", "inf", "-inf", "NaN", "1e999", "-1.#IND", "1,5", "1.5f", "0x10", "--1", "1e", "x", "1e61"}) {
    SCOPED_TRACE(bad);
    expect_refused("bad.obj", "# c\n" + corners + "v 0 " + bad + " 0\nf 1 2 3\n", "bad.obj:5:");
  }
  expect_refused("many.obj", corners + "v nan 0 0\nv 0 inf 0\nf 1 2 3\n", "2 like this in all");
  expect_refused("comma.obj", corners + "v 0,5 0 0\nf 1 2 3\n", "decimal comma");
  expect_refused("short.obj", corners + "v 1 2\nf 1 2 3\n", "short.obj:4:");
  EXPECT_EQ(read("tiny.obj", "v 1e-400 0 0\nv +1.5 0 0\nv 0 1E+0 0\nf 1 2 3\n").positions[1].x, 1.5);
}

TEST(Obj, BadLineNumbersCountContinuedAndCrLines) {
  expect_refused("l.obj", "v 0 0 \\\n0\r\nv 1 0 0\rv 0 1 0\nf 1 2 \\\n 9\n", "l.obj:6:");
}

TEST(Obj, FilesWithoutFacesAreRefused) {
  expect_refused("empty.obj", "", "empty");
  expect_refused("blank.obj", "\n\n  \n", "no triangles");
  expect_refused("points.obj", corners, "no triangles");
  expect_refused("curve.obj", corners + "cstype bezier\ndeg 3\ncurv 0 1 1 2 3\nsurf 0 1 0 1 1 2 3\nend\n",
                 "no triangles");
  expect_refused("words.obj", "this is not a model\nat all\n", "no triangles");
  expect_refused("line.obj", corners + "f 1 2\n", "2 corners");
  expect_refused("range.obj", corners + "f 1 2 3\nf 1 2 4\nf 4 5 1\n", "3 such corners");
  expect_refused("before.obj", corners + "f -4 -2 -1\n");
  expect_refused("vt.obj", corners + "vt 0 0\nf 1/1 2/2 3/1\n", "texture coordinate");
  expect_refused("vn.obj", corners + "f 1//1 2//1 3//1\n", "normal");
  expect_refused("huge_index.obj", corners + "f 1 2 99999999999999999999\n");
  expect_refused("nul.obj", corners + std::string("f 1 2 3\0", 8), "not text");
  expect_refused("utf16.obj", std::string_view("\xFF\xFEv\0 \0", 6), "UTF-16");
}

TEST(Off, HeadersAndColours) {
  const std::string hash = mesh_hash(as_mesh(tetrahedron())), plain = off(tetrahedron());
  EXPECT_EQ(mesh_hash(read("same_line.off", replaced(plain, "OFF\n", "OFF "))), hash);
  EXPECT_EQ(mesh_hash(read("modelnet.off", replaced(plain, "OFF\n", "OFF"))), hash);
  EXPECT_EQ(
      mesh_hash(read("comments.off", "# first\n" + replaced(plain, "4 4 0\n", "4 4 0 # counts\n# more\n\n"))),
      hash);
  EXPECT_EQ(mesh_hash(read("no_edges.off", replaced(plain, "4 4 0", "4 4"))), hash);
  const Mesh face = read("faces.off", replaced(plain, "3 0 1 2\n", "3 0 1 2 0.5 0.25 1.0\n"));
  EXPECT_EQ(face.triangles.size(), 4u);
  EXPECT_EQ(face.corner_color[2], glm::vec4(0.5, 0.25, 1, 1));
  EXPECT_EQ(face.corner_color[3], glm::vec4(1));
  EXPECT_EQ(read("bytes.off", replaced(plain, "3 0 1 2\n", "3 0 1 2 255 0 51 255\n")).corner_color[0],
            glm::vec4(1, 0, 0.2F, 1));
  EXPECT_TRUE(read("palette.off", replaced(plain, "3 0 1 2\n", "3 0 1 2 7\n")).corner_color.empty());
  const Mesh all = read("all.off",
                        "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 0.5 1\n1 0 0 0 0 1 0 255 0 255 1 0\n"
                        "0 1 0 0 0 1 0 0 255 255 0 0\n3 0 1 2\n");
  EXPECT_EQ(all.corner_uv[0], glm::vec2(0.5, 1));
  EXPECT_EQ(all.corner_color[1], glm::vec4(0, 1, 0, 1));
}

TEST(Off, BrokenFiles) {
  const std::string plain = off(tetrahedron());
  expect_refused("h.off", replaced(plain, "OFF\n", ""), "begin with OFF");
  expect_refused("b.off", std::string_view("OFF BINARY\n\0\0\0\1", 15), "binary OFF");
  expect_refused("4.off", "4OFF\n1 1 0\n", "three-dimensional");
  expect_refused("counts.off", replaced(plain, "4 4 0", "2000000000 2000000000 0"), "too short");
  expect_refused("negative.off", replaced(plain, "4 4 0", "-4 4 0"), "counts");
  expect_refused("overflow.off", replaced(plain, "4 4 0", "99999999999999999999 4 0"), "counts");
  expect_refused("valence.off", replaced(plain, "3 0 1 2", "2000000000 0 1 2"), "announces 2000000000");
  expect_refused("valence.off", replaced(plain, "3 0 1 2", "-3 0 1 2"));
  expect_refused("valence.off", replaced(plain, "3 0 1 2", "2 0 1"), "corners");
  expect_refused("range.off", replaced(plain, "3 0 1 2", "3 0 1 4"), "range.off:7:");
  expect_refused("range.off", replaced(plain, "3 0 1 2", "3 0 -1 2"));
  expect_refused("more.off", replaced(plain, "4 4 0", "4 3 0"), "more after");
  expect_refused("fewer.off", replaced(plain, "4 4 0", "4 5 0"));
  expect_refused("nan.off", replaced(plain, "0 1 0\n", "0 nan 0\n"), "nan.off:4:");
  expect_refused("values.off", replaced(plain, "0 1 0\n", "0 1 0 7\n"), "values");
  expect_refused("no_faces.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", "no triangles");
}

TEST(Stl, TextInTheWild) {
  const std::string plain = stl_text(tetrahedron()), hash = mesh_hash(as_mesh(tetrahedron()));
  std::string upper = plain;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(mesh_hash(read("u.stl", upper)), hash);
  EXPECT_EQ(mesh_hash(read("nan_normal.stl", replaced(plain, "normal 0 0 0", "normal nan nan nan"))), hash);
  EXPECT_EQ(read("two.stl", plain + plain).triangles.size(), 8u);
  ReadReport report;
  read("report.stl", plain, &report);
  EXPECT_EQ(report.weld.vertices_welded, 8u);
}

TEST(Stl, BrokenFiles) {
  const std::string text = stl_text(tetrahedron()), binary = stl_binary(tetrahedron());
  expect_refused("short.stl", binary.substr(0, binary.size() - 1), "284");
  expect_refused("long.stl", binary + '\0', "284");
  expect_refused("header.stl", binary.substr(0, 70));
  std::string huge = binary;
  huge.replace(80, 4, "\xFF\xFF\xFF\x7F");
  expect_refused("huge.stl", huge);
  std::string none = binary.substr(0, 84);
  none.replace(80, 4, std::string(4, '\0'));
  expect_refused("none.stl", none, "no triangles");
  std::string nan = binary;
  nan.replace(84 + 12, 4, number(std::numeric_limits<float>::quiet_NaN()));
  nan.replace(84 + 62, 4, number(std::numeric_limits<float>::infinity()));
  expect_refused("nan.stl", nan, "2 like this in all");
  expect_refused("cut.stl", text.substr(0, text.size() - 30));
  expect_refused("loop.stl", replaced(text, "endloop", "vertex 1 2 3\nendloop"), "endloop");
  expect_refused("number.stl", replaced(text, "vertex 0 0 0", "vertex 0 x 0"), "number.stl:4:");
  expect_refused("empty_solid.stl", "solid a\nendsolid a\n", "no triangles");
  expect_refused("words.stl", "hello world\n", "solid");
}

}  // namespace
