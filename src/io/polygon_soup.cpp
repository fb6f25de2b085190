#include "polygon_soup.hpp"

#include <fmt/format.h>

#include <array>

#include "ear_clip.hpp"
#include "file_bytes.hpp"
#include "text_numbers.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris::io {

namespace {

/// Counts the triangles that `soup` will give at most, and refuses what cannot be cut.
std::size_t count_triangles(const PolygonSoup& soup, const std::filesystem::path& file) {
  std::size_t triangles = 0;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const std::size_t corners = soup.face_end[f] - soup.face_begin(f);
    if (corners > most_corners)
      throw InputError(shown(file),
                       fmt::format("face {} has {} corners (the limit is {})", f + 1, corners, most_corners),
                       "triangulate the model in the program that made it, and export again");
    triangles += corners - 2;
  }
  if (triangles == 0) throw InputError(shown(file), "the file has no triangles or polygons", remedy_no_faces);
  if (triangles >= 0xFFFFFFFFu / 3)
    throw InputError(shown(file), fmt::format("{} triangles are too many", triangles), remedy_too_many);
  return triangles;
}

}  // namespace

Mesh to_mesh(PolygonSoup&& soup, const std::filesystem::path& file, ReadReport& report) {
  const std::size_t most_triangles = count_triangles(soup, file);
  report.file_vertices = soup.positions.size();
  report.file_faces = soup.faces();

  Mesh mesh;
  mesh.triangles.reserve(most_triangles);
  const bool with_uv = !soup.corner_uv.empty() || !soup.vertex_uv.empty();
  const bool with_color = !soup.vertex_color.empty() || !soup.face_color.empty();
  if (with_uv) mesh.corner_uv.reserve(3 * most_triangles);
  if (with_color) mesh.corner_color.reserve(3 * most_triangles);

  auto add = [&](std::size_t face, const std::array<std::size_t, 3>& corners) {
    glm::uvec3 triangle;
    for (int k = 0; k < 3; ++k) {
      const std::size_t corner = corners[static_cast<std::size_t>(k)];
      const std::uint32_t vertex = triangle[k] = soup.corner_vertex[corner];
      if (with_uv) {
        glm::vec2 uv(0.0F);
        if (!soup.vertex_uv.empty())
          uv = soup.vertex_uv[vertex];
        else if (soup.corner_uv[corner] != PolygonSoup::none)
          uv = soup.uv[soup.corner_uv[corner]];
        mesh.corner_uv.push_back(uv);
      }
      if (with_color)
        mesh.corner_color.push_back(soup.vertex_color.empty() ? soup.face_color[face]
                                                              : soup.vertex_color[vertex]);
    }
    mesh.triangles.push_back(triangle);
  };

  std::vector<glm::dvec3> outline;
  std::vector<std::array<std::uint32_t, 3>> cuts;
  for (std::size_t f = 0; f < soup.faces(); ++f) {
    const std::size_t begin = soup.face_begin(f), end = soup.face_end[f];
    if (end - begin == 3) {
      add(f, {begin, begin + 1, begin + 2});
      if (!mesh.face_of_triangle.empty()) mesh.face_of_triangle.push_back(static_cast<std::uint32_t>(f));
      continue;
    }
    if (report.polygons_triangulated++ == 0) {  // from here on triangles and faces count differently
      mesh.face_of_triangle.reserve(most_triangles);
      for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) mesh.face_of_triangle.push_back(t);
    }
    outline.clear();
    cuts.clear();
    for (std::size_t c = begin; c < end; ++c) outline.push_back(soup.positions[soup.corner_vertex[c]]);
    triangulate_polygon(outline, cuts);
    for (const auto& [a, b, c] : cuts) {
      add(f, {begin + a, begin + b, begin + c});
      mesh.face_of_triangle.push_back(static_cast<std::uint32_t>(f));
    }
  }
  mesh.positions = std::move(soup.positions);
  return mesh;
}

}  // namespace verdigris::io
