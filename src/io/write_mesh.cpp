#include "verdigris/io/write_mesh.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

namespace {

constexpr std::size_t block = 60000;

void flush(ReplaceFile& file, std::string& text, std::size_t from = block) {
  if (text.size() < from) return;
  file.write(text);
  text.clear();
}

void write_obj(const std::filesystem::path& target, const Mesh& mesh) {
  ReplaceFile file(target);
  std::string text;
  for (const glm::dvec3& p : mesh.positions) {
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", p.x, p.y, p.z);
    flush(file, text);
  }
  for (const glm::uvec3& t : mesh.triangles) {
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
    flush(file, text);
  }
  flush(file, text, 0);
  file.commit();
}

void write_ply(const std::filesystem::path& target, const Mesh& mesh) {
  ReplaceFile file(target);
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\n"
                  "property double y\nproperty double z\nelement face {}\n"
                  "property list uchar uint vertex_indices\nend_header\n",
                  mesh.positions.size(), mesh.triangles.size()));
  static_assert(sizeof(glm::dvec3) == 24 && sizeof(glm::uvec3) == 12);
  file.write(mesh.positions.data(), mesh.positions.size() * sizeof(glm::dvec3));
  std::string text;
  for (const glm::uvec3& t : mesh.triangles) {
    text += '\3';
    text.append(reinterpret_cast<const char*>(&t), sizeof t);
    flush(file, text);
  }
  flush(file, text, 0);
  file.commit();
}

}  // namespace

void write_mesh(const std::filesystem::path& file, const Mesh& mesh) {
  const std::string ending = file.extension().string();
  if (ending == ".obj")
    write_obj(file, mesh);
  else if (ending == ".ply")
    write_ply(file, mesh);
  else
    throw InputError(file.string(), fmt::format("meshes are not written as '{}'", ending),
                     "give a name that ends in .obj or .ply");
}

}  // namespace verdigris
