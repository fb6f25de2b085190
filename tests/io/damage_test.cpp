// Files that are not there, not files, cut off, or damaged in any way: a mesh or InputError, nothing else.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cmath>
#include <random>

#include "model_files.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

namespace fs = std::filesystem;

struct Sample {
  std::string extension, bytes;
};

std::vector<Sample> samples() {
  const Polygons model = tetrahedron();
  const std::string color_ply = replaced(ply_text(cube()), "comment made by a test\n", "");
  return {{".obj", obj(model) + "vt 0 1\nvn 0 0 1\nf 1/1/1 2/1/1 3//1\nf -1 -2 \\\n-3\n"},
          {".off", off(cube())},
          {".off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0.5 0.5\n0 1 0 0 0 0 1\n3 0 1 2 1 1 1\n"},
          {".ply", color_ply},
          {".ply", ply_binary(model, false)},
          {".ply", ply_binary(cube(), true)},
          {".stl", stl_text(model)},
          {".stl", stl_binary(model)},
          {".om", om_lists(cube())},
          {".om", om_tetrahedron()},
          {".glb", glb(gltf_parts(model))},
          {".gltf", gltf_embedded(gltf_parts(model))}};
}

const std::vector<std::string> extensions{".obj", ".off", ".ply", ".stl", ".om", ".glb", ".gltf"};

TEST(Damage, WhatIsNoFileIsRefused) {
  for (const std::string& extension : extensions) {
    expect_file_refused(directory() / ("missing" + extension), "no such file");
    fs::create_directories(directory() / ("folder" + extension));
    expect_file_refused(directory() / ("folder" + extension), "directory");
    const fs::path pipe = directory() / ("pipe" + extension);
    if (mkfifo(pipe.c_str(), 0600) == 0) expect_file_refused(pipe, "pipe");
    expect_refused("empty" + extension, "", "empty");
  }
  std::error_code error;
  fs::create_symlink("/dev/zero", directory() / "endless.obj", error);
  if (!error) expect_file_refused(directory() / "endless.obj", "device");
}

TEST(Damage, NonsenseIsRefused) {
  std::mt19937 random(1);
  for (const std::string& extension : extensions)
    for (const std::size_t size : {1u, 2u, 3u, 15u, 16u, 83u, 84u, 85u, 134u, 1000u, 65536u}) {
      std::string bytes(size, '\0');
      expect_refused("zeros" + extension, bytes);
      for (char& c : bytes) c = static_cast<char>(random());
      expect_refused("random" + extension, bytes);
      for (char& c : bytes) c = " \n0123456789vf.-eE/"[random() % 19];
      try {
        read("digits" + extension, bytes);
      } catch (const InputError&) {
      }
      expect_refused("spaces" + extension, std::string(size, ' '));
      expect_refused("cr" + extension, std::string(size, '\r'));
      expect_refused("words" + extension, std::string(size, 'x'));
    }
}

TEST(Damage, CutOffFilesAreRefusedOrSmaller) {
  for (const Sample& s : samples())
    for (std::size_t part = 1; part < 8; ++part) {
      const std::string cut = s.bytes.substr(0, s.bytes.size() * part / 8);
      SCOPED_TRACE(s.extension + " " + std::to_string(part) + "/8");
      if (s.extension == ".obj") {  // OBJ has no counts: less is still a model, if it has faces
        try {
          read("cut.obj", cut);
        } catch (const InputError& e) {
          EXPECT_FALSE(e.remedy().empty());
        }
      } else {
        expect_refused("cut" + s.extension, cut);
      }
    }
}

TEST(Damage, HugeCountsTakeNoMemory) {
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  for (const char* count : {"2000000000", "4294967295", "4294967296", "9223372036854775807", "-1"}) {
    const std::string c = count;
    expect_refused("v.off", replaced(off(cube()), "8 6", c + " 6"));
    expect_refused("f.off", replaced(off(cube()), "8 6", "8 " + c));
    expect_refused("c.off", replaced(off(cube()), "4 0 1 2 3", c + " 0 1 2 3"));
    for (const std::string& bytes : {ply_text(cube()), ply_binary(cube(), false), ply_binary(cube(), true)}) {
      expect_refused("v.ply", replaced(bytes, "vertex 8", "vertex " + c));
      expect_refused("f.ply", replaced(bytes, "face 6", "face " + c));
    }
    expect_refused("c.ply", replaced(ply_text(cube()), "\n4 0 1 2 3", "\n" + c + " 0 1 2 3"));
    const Gltf parts = gltf_parts(tetrahedron());
    for (const char* where :
         {"\"count\":4", "\"count\":12", "\"byteLength\":48", "\"byteLength\":24", "\"byteLength\":72"}) {
      const std::string key = std::string(where).substr(0, std::string(where).find(':') + 1);
      expect_refused("n.glb", glb({replaced(parts.json, where, key + c), parts.buffer}));
    }
  }
  for (const std::size_t at : {4u, 8u, 12u})
    for (const std::string& om : {om_tetrahedron(), om_lists(cube())})
      for (const std::uint32_t n : {2000000000u, 0xFFFFFFFFu}) {
        if (at == 12 && om[3] == '\x22') continue;  // old versions do not use the count of edges
        std::string bytes = om;
        bytes.replace(at, 4, number(n));
        expect_refused("n.om", bytes);
      }
  std::string stl = stl_binary(cube().faces.empty() ? cube() : tetrahedron());
  stl.replace(80, 4, number(0xFFFFFFFFu));
  expect_refused("n.stl", stl);
  getrusage(RUSAGE_SELF, &after);
#if !defined(__SANITIZE_ADDRESS__)
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 100 * 1024);  // kilobytes
#endif
}

TEST(Damage, OmTopologyIsChecked) {
  const std::string good = om_tetrahedron();
  for (std::size_t at = 16 + 2 + 48 + 2; at < good.size() - 2; ++at)
    for (const char value : {'\x7F', '\x80', '\xFE'}) {
      std::string bytes = good;
      bytes[at] = value;
      SCOPED_TRACE(at);
      expect_refused("topology.om", bytes);
    }
  const std::string lists = om_lists(tetrahedron());
  std::string bytes = lists;
  bytes.replace(16 + 2 + 48 + 2 + 2, 4, number(77u));
  expect_refused("range.om", bytes, "vertex 77");
  bytes.replace(16 + 2 + 48 + 2 + 2, 4, number(1u));  // the second corner again: OpenMesh would abort
  expect_refused("repeat.om", bytes, "repeats");
  bytes = lists;
  bytes.replace(18, 4, number(std::numeric_limits<float>::quiet_NaN()));
  expect_refused("nan.om", bytes, "not finite");
  bytes = lists;
  bytes[3] = '\x43';
  expect_refused("new.om", bytes, "newer");
  bytes = lists;
  bytes[2] = 'X';
  expect_refused("kind.om", bytes);
}

/// One small change of the kinds that damage and bad exporters make.
void mutate(std::string& bytes, std::mt19937& random) {
  static const std::vector<std::string> words{"-1",    "0",    "2000000000", "4294967295", "1e999", "nan",
                                              "1,5",   "\\\n", "\r",         "\"",         "[",     "}",
                                              "null",  "99",   "-0",         "#",          " ",     "\xFF",
                                              "f 1 2", ":",    "true",       "1e-999",     "..",    "3 0 1"};
  auto at = [&](std::size_t end) { return end == 0 ? 0 : random() % end; };
  if (bytes.empty()) bytes = "x";
  switch (random() % 8) {
    case 0:
      bytes[at(bytes.size())] = static_cast<char>(random());
      break;
    case 1:
      bytes[at(bytes.size())] ^= static_cast<char>(1 << random() % 8);
      break;
    case 2:
      bytes.insert(at(bytes.size()), words[at(words.size())]);
      break;
    case 3:
      bytes.erase(at(bytes.size()), 1 + at(8));
      break;
    case 4: {
      const std::string part = bytes.substr(at(bytes.size()), at(40));
      bytes.insert(at(bytes.size()), part);
      break;
    }
    case 5: {  // a number of the text becomes another
      const std::size_t digit = bytes.find_first_of("0123456789", at(bytes.size()));
      if (digit != std::string::npos) bytes.replace(digit, 1, words[at(words.size())]);
      break;
    }
    case 6: {  // a whole word of a binary file
      const std::string value(4, random() % 2 ? '\xFF' : '\x7F');
      if (bytes.size() >= 4) bytes.replace(at(bytes.size() - 3), 4, value);
      break;
    }
    default:
      if (random() % 8 == 0) bytes.resize(at(bytes.size()));
  }
}

TEST(Damage, MutatedFilesGiveAMeshOrInputError) {
  std::mt19937 random(20240607);
  for (const Sample& s : samples()) {
    SCOPED_TRACE(s.extension);
    std::size_t meshes = 0, refused = 0;
    const std::string name = "mutated" + s.extension;
    const int rounds = s.extension[1] == 'g' ? 1500 : 3000;  // JSON takes longer
    for (int round = 0; round < rounds; ++round) {
      std::string bytes = s.bytes;
      for (auto n = 1 + random() % 3; n > 0; --n) mutate(bytes, random);
      try {
        const Mesh mesh = read(name, bytes);
        ++meshes;
        ASSERT_FALSE(mesh.triangles.empty());
        for (const glm::uvec3& t : mesh.triangles)
          for (int k = 0; k < 3; ++k) ASSERT_LT(t[k], mesh.positions.size());
        for (const glm::dvec3& p : mesh.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
        for (const std::size_t corners : {mesh.corner_uv.size(), mesh.corner_color.size()})
          ASSERT_TRUE(corners == 0 || corners == 3 * mesh.triangles.size());
        for (const std::uint32_t v : mesh.vertex_of_file) ASSERT_LT(v, mesh.positions.size());
      } catch (const InputError& e) {
        ++refused;
        ASSERT_NE(std::string_view(e.what()).find(name), std::string_view::npos) << e.what();
        ASSERT_FALSE(e.remedy().empty()) << e.what();
      }
    }
    EXPECT_GT(meshes, 0u);
    EXPECT_GT(refused, 0u);
  }
}

}  // namespace
