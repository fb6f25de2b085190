#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "model_files.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

const Gltf model = gltf_parts(tetrahedron());

Mesh read_with(std::string_view from, std::string_view to) {
  return read("m.glb", glb({replaced(model.json, from, to), model.buffer}));
}

void expect_refused_with(std::string_view from, std::string_view to, std::string_view problem = "") {
  expect_refused("m.glb", glb({replaced(model.json, from, to), model.buffer}), problem);
}

double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    sum += glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6.0;
  return sum;
}

TEST(Gltf, NodesPutMeshesInPlace) {
  const Mesh moved = read_with(R"("nodes":[{"mesh":0}])",
                               R"("nodes":[{"children":[1],"translation":[10,0,0],"scale":[2,2,2]},)"
                               R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476]}])");
  EXPECT_NEAR(glm::distance(moved.positions[2], glm::dvec3(10, 2, 0)), 0.0, 1e-12);
  EXPECT_NEAR(volume(moved), 8.0 / 6.0, 1e-12);
  const Mesh matrix = read_with(R"({"mesh":0})", R"({"mesh":0,"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,5,6,7,1]})");
  EXPECT_EQ(matrix.positions[2], glm::dvec3(5, 7, 7));
}

TEST(Gltf, MirroredNodesAreTurnedOutward) {
  EXPECT_NEAR(volume(read_with(R"({"mesh":0})", R"({"mesh":0,"scale":[-1,1,1]})")), 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(volume(read_with(R"({"mesh":0})", R"({"mesh":0,"scale":[-1,-2,1]})")), 2.0 / 6.0, 1e-12);
}

TEST(Gltf, InstancesAndScenes) {
  const Mesh two =
      read_with(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])",
                R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"translation":[5,0,0]}])");
  EXPECT_EQ(two.triangles.size(), 8u);
  EXPECT_EQ(read_with(R"("scene":0,"scenes":[{"nodes":[0]}],)", "").triangles.size(), 4u);
  EXPECT_EQ(read_with(R"("scene":0,)", "").triangles.size(), 4u);
}

TEST(Gltf, StripsFansAndLists) {
  std::string buffer;
  for (const auto& p : {glm::vec3(0, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(1, 1, 0)})
    for (int c = 0; c < 3; ++c) buffer += number(p[c]);
  auto drawn = [&](int mode, int count) {
    return read(
        "mode.glb",
        glb({R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
             R"({"attributes":{"POSITION":0},"mode":)" +
                 std::to_string(mode) +
                 R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
                 std::to_string(count) +
                 R"(}],"bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{"byteLength":48}]})",
             buffer}));
  };
  EXPECT_EQ(drawn(5, 4).triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {1, 3, 2}}));
  EXPECT_EQ(drawn(6, 4).triangles, (std::vector<glm::uvec3>{{1, 2, 0}, {2, 3, 0}}));
  EXPECT_EQ(drawn(4, 3).triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
  EXPECT_THROW(drawn(4, 4), std::runtime_error);
  EXPECT_THROW(drawn(0, 4), std::runtime_error);  // points
  EXPECT_THROW(drawn(9, 4), std::runtime_error);
}

TEST(Gltf, TextureCoordinatesColoursAndQuantization) {
  std::string buffer;
  for (const int x : {0, 0, 0, 127, 0, 0, 0, 127, 0})
    buffer += static_cast<char>(x);  // VEC3 of bytes, normalised
  buffer += std::string(3, '\0');
  for (const int x : {0, 65535, 65535, 0, 0, 0}) buffer += number(static_cast<std::uint16_t>(x));
  for (const int x : {255, 0, 51, 255, 0, 255, 0, 0, 1, 2, 3, 4}) buffer += static_cast<char>(x);
  const Mesh mesh = read(
      "q.glb",
      glb({R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_mesh_quantization"],"extensionsRequired":[)"
           R"("KHR_mesh_quantization"],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[3,3,3]}],"meshes":[)"
           R"({"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1,"COLOR_0":2},"material":5}]}],"accessors":[)"
           R"({"bufferView":0,"componentType":5120,"normalized":true,"count":3,"type":"VEC3"},)"
           R"({"bufferView":0,"byteOffset":12,"componentType":5123,"normalized":true,"count":3,"type":"VEC2"},)"
           R"({"bufferView":0,"byteOffset":24,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]})",
           buffer}));
  EXPECT_EQ(mesh.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}));
  EXPECT_EQ(mesh.corner_uv, (std::vector<glm::vec2>{{0, 0}, {1, 1}, {0, 1}}));  // v upwards
  EXPECT_EQ(mesh.corner_color[0], glm::vec4(1, 0, 0.2F, 1));
}

TEST(Gltf, SparseAccessors) {
  std::string buffer = model.buffer + number<std::uint16_t>(3) + std::string(2, '\0');
  for (const float x : {0.0F, 0.0F, 4.0F}) buffer += number(x);
  std::string json =
      replaced(model.json, R"("count":4,)",
               R"("count":4,"sparse":{"count":1,"indices":{"bufferView":2,"componentType":5123},)"
               R"("values":{"bufferView":3}},)");
  json = replaced(
      json, R"(}],"buffers":[{"byteLength":72)",
      R"(},{"buffer":0,"byteOffset":72,"byteLength":2},{"buffer":0,"byteOffset":76,"byteLength":12}],)"
      R"("buffers":[{"byteLength":88)");
  EXPECT_EQ(read("s.glb", glb({json, buffer})).positions[3], glm::dvec3(0, 0, 4));
  buffer[72] = 4;
  expect_refused("s.glb", glb({json, buffer}), "sparse");
}

TEST(Gltf, ExternalBuffersStayBesideTheFile) {
  auto with_uri = [](const std::string& uri) {
    return replaced(model.json, R"("buffers":[{)", R"("buffers":[{"uri":")" + uri + R"(",)");
  };
  write("beside it.bin", model.buffer);
  EXPECT_EQ(mesh_hash(read("x.gltf", with_uri("beside%20it.bin"))), mesh_hash(as_mesh(tetrahedron())));
  expect_refused("x.gltf", with_uri("missing.bin"), "no such file");
  for (const char* uri : {"../beside it.bin", "a/../../b.bin", "%2e%2e/b.bin", "..\\\\b.bin", "/etc/hostname",
                          "file:///etc/hostname", "http://localhost/b.bin", "C:/b.bin", "~/b.bin", ""}) {
    SCOPED_TRACE(uri);
    expect_refused("x.gltf", with_uri(uri), "not beside the file");
  }
  write("short.bin", model.buffer.substr(0, 70));
  expect_refused("x.gltf", with_uri("short.bin"), "at most 70");
  std::filesystem::create_directories(directory() / "dir.bin");
  EXPECT_THROW(read("x.gltf", with_uri("dir.bin")), std::runtime_error);
  expect_refused("x.gltf", with_uri("data:application/octet-stream;base64,AAAA"), "at most");
  expect_refused("x.gltf", with_uri("data:text/plain,hello"), "data URI");
}

TEST(Gltf, BrokenReferences) {
  expect_refused_with(R"("POSITION":0)", R"("POSITION":7)", "accessor 7");
  expect_refused_with(R"("indices":1)", R"("indices":9)", "accessor");
  expect_refused_with(R"("indices":1)", R"("indices":0)", "indices");
  expect_refused_with(R"("mesh":0)", R"("mesh":3)", "mesh 3");
  expect_refused_with(R"("nodes":[0])", R"("nodes":[5])", "node 5");
  expect_refused_with(R"("nodes":[0])", R"("nodes":[-5])");
  expect_refused_with(R"("scene":0)", R"("scene":4)", "scene 4");
  expect_refused_with(R"({"mesh":0})", R"({"mesh":0,"children":[0]})", "twice");
  expect_refused_with(R"("nodes":[{"mesh":0}])", R"("nodes":[{"mesh":0,"children":[1]},{"children":[0]}])",
                      "twice");
  expect_refused_with(R"("bufferView":1)", R"("bufferView":8)", "ufferView");
  expect_refused_with(R"("count":4)", R"("count":2000000000)", "2000000000");
  expect_refused_with(R"("count":4)", R"("count":-1)");
  expect_refused_with(R"("count":4)", R"("count":5000)");
  expect_refused_with(R"("count":4)", R"("count":3)", "points to no vertex");
  expect_refused_with(R"("count":12)", R"("count":11)", "whole triangles");
  expect_refused_with(R"("count":4)", R"("count":4,"byteOffset":4)", "ends behind");
  expect_refused_with(R"("count":4)", R"("count":4,"byteOffset":18446744073709551615)");
  expect_refused_with(R"("byteOffset":48)", R"("byteOffset":4800)", "ends behind");
  expect_refused_with(R"("componentType":5126)", R"("componentType":77)");
  expect_refused_with(R"("type":"VEC3")", R"("type":"MAT4")");
  expect_refused_with(R"("buffers":[{"byteLength":72)", R"("buffers":[{"byteLength":2000000000)",
                      "2000000000");
  expect_refused_with(R"({"buffer":0)", R"({"buffer":5)", "buffer 5");
  expect_refused_with(R"({"buffer":0,)", R"({"buffer":0,"byteStride":4,)");
  expect_refused_with(R"({"mesh":0})", R"({"mesh":0,"scale":[1]})", "node 0");
  expect_refused_with(R"({"mesh":0})", R"({"mesh":0,"scale":[1e300,1,1]})", "too large");
  std::string buffer = model.buffer;
  buffer.replace(0, 4, number(std::numeric_limits<float>::quiet_NaN()));
  expect_refused("nan.glb", glb({model.json, buffer}), "not finite");
}

TEST(Gltf, ManyInstancesAreBounded) {
  std::string nodes = R"("nodes":[0)", all = R"("nodes":[{"mesh":0})";
  // A mesh that is one long list of the same few corners, shown over and over: a small file, a huge result.
  for (int i = 1; i < 3000; ++i) {
    nodes += ',';
    nodes += std::to_string(i);
    all += R"(,{"mesh":0})";
  }
  std::string json = replaced(model.json, R"("nodes":[{"mesh":0})", all);
  json = replaced(json, R"("nodes":[0)", nodes);
  std::string buffer = model.buffer;
  for (int i = 0; i < 3000; ++i) buffer += model.buffer.substr(48, 6);
  json = replaced(json, R"("count":12)", R"("count":9012)");
  json = replaced(json, R"("byteLength":24)", R"("byteLength":18024)");
  json = replaced(json, R"("byteLength":72)", R"("byteLength":18072)");
  expect_refused("many.glb", glb({json, buffer}), "more than the file can hold");
}

TEST(Gltf, ExtensionsThatChangeGeometryAreRefused) {
  expect_refused_with(R"({"asset")", R"({"extensionsRequired":["VENDOR_unknown"],"asset")", "VENDOR_unknown");
  expect_refused_with(R"({"asset")", R"({"extensionsRequired":["KHR_draco_mesh_compression"],"asset")",
                      "draco");
  expect_refused_with(R"({"attributes")", R"({"extensions":{"KHR_draco_mesh_compression":{}},"attributes")",
                      "Draco");
  expect_refused_with(R"({"buffer":0)", R"({"extensions":{"EXT_meshopt_compression":{}},"buffer":0)",
                      "meshopt");
  expect_refused_with(R"({"mesh":0})", R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}})", "copies");
  EXPECT_EQ(
      read_with(R"({"asset")", R"({"extensionsRequired":["KHR_materials_unlit"],"asset")").triangles.size(),
      4u);
}

TEST(Gltf, ImagesAreNotLookedAt) {
  // An image view past the end of the buffer crashes tinygltf 2.7.
  const Mesh mesh =
      read_with(R"("buffers")", R"("images":[{"bufferView":2,"mimeType":"image/png"},{"uri":"../x.png"}],)"
                                R"("materials":[{"name":1}],"textures":7,"buffers")");
  EXPECT_EQ(mesh.triangles.size(), 4u);
}

TEST(Gltf, BrokenContainers) {
  const std::string good = glb(model);
  expect_refused("v1.glb", replaced(good, std::string_view("glTF\2", 5), "glTF\1"), "version 1");
  expect_refused("magic.glb", replaced(good, "glTF", "glTG"), "JSON");
  expect_refused("cut.glb", good.substr(0, good.size() - 4));
  expect_refused("none.glb", good.substr(0, 12));
  std::string chunk = good;
  chunk.replace(12, 4, "\xFF\xFF\xFF\x7F");
  expect_refused("chunk.glb", chunk, "chunk");
  expect_refused("deep.gltf", R"({"asset":)" + std::string(100000, '[') + std::string(100000, ']') + "}",
                 "nested");
  expect_refused("deep.gltf", std::string(100000, '['), "nested");
  expect_refused("json.gltf", R"({"asset":{"version":"2.0"},)", "malformed");
  expect_refused("list.gltf", "[1,2,3]", "not an object");
  expect_refused("v1.gltf", R"({"asset":{"version":"1.0"}})", "glTF 2");
  expect_refused("bare.gltf", R"({"asset":{"version":"2.0"}})");
  expect_refused("types.gltf", R"({"asset":{"version":"2.0"},"nodes":{"a":1},"meshes":5})",
                 "list of objects");
  expect_refused("utf8.gltf", "{\"asset\":{\"version\":\"2.0\",\"x\":\"\xFF\xFE\"}}", "malformed");
}

}  // namespace
