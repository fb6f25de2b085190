#include "model_files.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "verdigris/base/error.hpp"

namespace verdigris::model_files {

namespace fs = std::filesystem;

namespace {

struct TemporaryDirectory {
  TemporaryDirectory() : path(fs::temp_directory_path() / ("verdigris_io_" + std::to_string(getpid()))) {
    fs::create_directories(path);
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  fs::path path;
};

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.17g", value);
  return buffer;
}

std::string xyz(const glm::dvec3& p) {
  return text(p.x) + " " + text(p.y) + " " + text(p.z);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : digits[word >> (18 - 6 * k) & 63];
  }
  return out;
}

std::string ply_header(const Polygons& polygons, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment made by a test\nelement vertex " +
         std::to_string(polygons.positions.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
         std::to_string(polygons.faces.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

const fs::path& directory() {
  static const TemporaryDirectory temporary;
  return temporary.path;
}

fs::path write(const std::string& name, std::string_view bytes) {
  const fs::path file = directory() / name;
  fs::remove(file);  // writing over a file makes some file systems wait for the disk
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

void expect_file_refused(const fs::path& file, std::string_view problem) {
  try {
    const Mesh mesh = read_mesh(file);
    ADD_FAILURE() << file << " gave a mesh of " << mesh.triangles.size() << " triangles";
  } catch (const InputError& e) {
    EXPECT_NE(e.where().find(file.filename().string()), std::string::npos) << e.what();
    EXPECT_FALSE(e.problem().empty()) << e.what();
    EXPECT_FALSE(e.remedy().empty()) << e.what();
    EXPECT_NE(std::string_view(e.what()).find(problem), std::string_view::npos) << e.what();
  }
}

void expect_refused(const std::string& name, std::string_view bytes, std::string_view problem) {
  SCOPED_TRACE(std::string(bytes.substr(0, 200)));
  expect_file_refused(write(name, bytes), problem);
}

Polygons tetrahedron() {
  return {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

Polygons cube() {
  return {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
          {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 5, 4}, {3, 2, 6, 5}, {2, 1, 7, 6}, {1, 0, 4, 7}}};
}

Mesh as_mesh(const Polygons& polygons) {
  Mesh mesh;
  mesh.positions = polygons.positions;
  for (const auto& f : polygons.faces) mesh.triangles.push_back({f[0], f[1], f[2]});
  return mesh;
}

std::string obj(const Polygons& polygons) {
  std::string out = "# made by a test\n";
  for (const auto& p : polygons.positions) out += "v " + xyz(p) + "\n";
  for (const auto& face : polygons.faces) {
    out += "f";
    for (const std::uint32_t v : face) (out += ' ') += std::to_string(v + 1);
    out += "\n";
  }
  return out;
}

std::string off(const Polygons& polygons) {
  std::string out = "OFF\n" + std::to_string(polygons.positions.size()) + " " +
                    std::to_string(polygons.faces.size()) + " 0\n";
  for (const auto& p : polygons.positions) out += xyz(p) + "\n";
  for (const auto& face : polygons.faces) {
    out += std::to_string(face.size());
    for (const std::uint32_t v : face) (out += ' ') += std::to_string(v);
    out += "\n";
  }
  return out;
}

std::string ply_text(const Polygons& polygons) {
  const std::string body = off(polygons);  // after its two lines the rows are the same
  return ply_header(polygons, "ascii") + body.substr(body.find('\n', 4) + 1);
}

std::string ply_binary(const Polygons& polygons, bool big_endian) {
  std::string out = ply_header(polygons, big_endian ? "binary_big_endian" : "binary_little_endian");
  for (const auto& p : polygons.positions)
    for (int c = 0; c < 3; ++c) out += number(p[c], big_endian);
  for (const auto& face : polygons.faces) {
    out += static_cast<char>(face.size());
    for (const std::uint32_t v : face) out += number(v, big_endian);
  }
  return out;
}

std::string stl_text(const Polygons& polygons) {
  std::string out = "solid made by a test\n";
  for (const auto& face : polygons.faces) {
    out += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t v : face) out += "  vertex " + xyz(polygons.positions[v]) + "\n";
    out += " endloop\nendfacet\n";
  }
  return out + "endsolid made by a test\n";
}

std::string stl_binary(const Polygons& polygons) {
  std::string out = "solid is how this binary file begins";  // as many do
  out.resize(80, ' ');
  out += number(static_cast<std::uint32_t>(polygons.faces.size()));
  for (const auto& face : polygons.faces) {
    out += std::string(12, '\0');
    for (const std::uint32_t v : face)
      for (int c = 0; c < 3; ++c) out += number(static_cast<float>(polygons.positions[v][c]));
    out += std::string(2, '\0');
  }
  return out;
}

std::string om_lists(const Polygons& polygons) {
  std::string out = "OMP\x22";
  out += number(static_cast<std::uint32_t>(polygons.positions.size()));
  out += number(static_cast<std::uint32_t>(polygons.faces.size()));
  out += number(std::uint32_t{0});
  out += number(std::uint16_t{0x1600});  // vertex positions, 3 float32
  for (const auto& p : polygons.positions)
    for (int c = 0; c < 3; ++c) out += number(static_cast<float>(p[c]));
  out += number(std::uint16_t{0x80E8});  // face topology, 32 bits
  for (const auto& face : polygons.faces) {
    out += number(static_cast<std::uint16_t>(face.size()));
    for (const std::uint32_t v : face) out += number(v);
  }
  return out;
}

std::string om_tetrahedron() {
  // The vertices of tetrahedron() are here in the order 0, 2, 1, 3.
  std::string out = "OMPB";
  for (const std::uint32_t n : {4u, 4u, 6u}) out += number(n);
  out += number(std::uint16_t{0x1600});
  for (const int x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) out += number(static_cast<float>(x));
  out += number(std::uint16_t{0x16F8});  // half-edges: next, to, face, in pairs
  for (const int i : {2, 2, 0, 9, 0, 3, 4, 1, 0, 10, 2, 2, 0, 0, 0, 6, 1, 1,
                      8, 3, 1, 3, 1, 2, 5, 0, 1, 11, 3, 3, 7, 3, 2, 1, 2, 3})
    out += static_cast<char>(i);
  out += number(std::uint16_t{0x06E0});  // a half-edge of each vertex
  for (const int i : {9, 3, 1, 11}) out += static_cast<char>(i);
  out += number(std::uint16_t{0x06E8});  // a half-edge of each face
  for (const int i : {4, 8, 7, 1}) out += static_cast<char>(i);
  return out + number(std::uint16_t{0x001C});  // the end
}

Gltf gltf_parts(const Polygons& polygons) {
  Gltf parts;
  for (const auto& p : polygons.positions)
    for (int c = 0; c < 3; ++c) parts.buffer += number(static_cast<float>(p[c]));
  const std::string vertices = std::to_string(polygons.positions.size()),
                    split = std::to_string(parts.buffer.size());
  std::uint32_t corners = 0;
  for (const auto& face : polygons.faces)
    for (const std::uint32_t v : face) {
      parts.buffer += number(static_cast<std::uint16_t>(v));
      ++corners;
    }
  const std::string total = std::to_string(parts.buffer.size()), indices = std::to_string(2 * corners);
  parts.json = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
               R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)"
               R"({"bufferView":0,"componentType":5126,"count":)" +
               vertices + R"(,"type":"VEC3"},)" + R"({"bufferView":1,"componentType":5123,"count":)" +
               std::to_string(corners) + R"(,"type":"SCALAR"}],)" +
               R"("bufferViews":[{"buffer":0,"byteLength":)" + split + R"(},{"buffer":0,"byteOffset":)" +
               split + R"(,"byteLength":)" + indices + R"(}],"buffers":[{"byteLength":)" + total + "}]}";
  return parts;
}

std::string glb(const Gltf& parts) {
  std::string json = parts.json, buffer = parts.buffer;
  json.resize((json.size() + 3) / 4 * 4, ' ');
  buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
  auto word = [](std::size_t n) { return number(static_cast<std::uint32_t>(n)); };
  return "glTF" + word(2) + word(12 + 8 + json.size() + 8 + buffer.size()) + word(json.size()) + "JSON" +
         json + word(buffer.size()) + std::string("BIN\0", 4) + buffer;
}

std::string gltf_embedded(const Gltf& parts) {
  return replaced(
      parts.json, R"("buffers":[{)",
      R"("buffers":[{"uri":"data:application/octet-stream;base64,)" + base64(parts.buffer) + R"(",)");
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
    ADD_FAILURE() << "the test's own model does not have " << from;
  else
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace verdigris::model_files
