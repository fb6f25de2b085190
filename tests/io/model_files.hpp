#pragma once
// Small models written by the tests themselves, in every format, and what reading them gives.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "verdigris/io/read_mesh.hpp"

namespace verdigris::model_files {

/// A directory of this process that goes when the test program ends.
const std::filesystem::path& directory();

/// Writes `bytes` to a file `name` there.
std::filesystem::path write(const std::string& name, std::string_view bytes);

inline Mesh read(const std::string& name, std::string_view bytes, ReadReport* report = nullptr) {
  return read_mesh(write(name, bytes), report);
}

/// Expects InputError that names the file, says `problem` somewhere, and has a remedy.
void expect_refused(const std::string& name, std::string_view bytes, std::string_view problem = "");
void expect_file_refused(const std::filesystem::path& file, std::string_view problem = "");

/// Faces of any number of corners.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Vertices are numbered as triangles first use them, so that formats without vertices (STL) number them
/// alike.
Polygons tetrahedron();
Polygons cube();  ///< of six quads
/// The mesh that `polygons` of triangles only are.
Mesh as_mesh(const Polygons& polygons);

std::string obj(const Polygons& polygons);
std::string off(const Polygons& polygons);
std::string ply_text(const Polygons& polygons);
std::string ply_binary(const Polygons& polygons, bool big_endian);
std::string stl_text(const Polygons& polygons);
std::string stl_binary(const Polygons& polygons);
std::string om_lists(const Polygons& polygons);  ///< version 1.2: faces as lists of vertices
std::string om_tetrahedron();                    ///< version 2.2, as OpenMesh 9 writes it

/// A number in the file's byte order, little-endian unless said otherwise.
template <class T>
std::string number(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// The JSON of a glTF file and its one buffer.
struct Gltf {
  std::string json, buffer;
};
Gltf gltf_parts(const Polygons& polygons);
std::string glb(const Gltf& parts);
std::string gltf_embedded(const Gltf& parts);  ///< the buffer in a data URI

/// `text` with the first `from` replaced by `to`; a test failure when it is not there.
std::string replaced(std::string text, std::string_view from, std::string_view to);

}  // namespace verdigris::model_files
