#include "verdigris/exposure/mesh_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "at_cells.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

Field<float> interpolate_vertex_values(const Surface& surface, std::span<const double> values) {
  const Mesh& mesh = surface.mesh();
  if (values.size() != mesh.positions.size()) throw std::invalid_argument("not one value a vertex");
  return at_cells(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    const Frame& f = surface.frame(patch);
    const auto at = [&](std::uint8_t k) { return values[mesh.triangles[patch][(f.first_corner + k) % 3]]; };
    const glm::dvec3 w = corner_weights(f, p);
    return w.x * at(0) + w.y * at(1) + w.z * at(2);
  });
}

Field<float> spread_triangle_values(const Surface& surface, std::span<const double> values) {
  if (values.size() != surface.patch_count()) throw std::invalid_argument("not one value a triangle");
  return at_cells(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2) { return values[patch]; });
}

Field<float> file_values(const Surface& surface, std::span<const double> values, std::size_t file_vertices,
                         std::size_t file_faces, const std::string& on, const std::string& where) {
  const Mesh& mesh = surface.mesh();
  if (on.empty() && file_vertices == file_faces && values.size() == file_faces)
    throw InputError(where, "the model has as many vertices as faces: the values may be on either",
                     "say --barrier-mask-on vertices or faces (barrier.mask_on in a scene)");
  if (values.size() == file_vertices && on != "faces") {
    // Vertices that were welded into one: the greatest counts, a barrier drawn on one side of a seam holds.
    std::vector<double> on_vertex(mesh.positions.size(), -1e300);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::size_t vertex = mesh.vertex_of_file.empty() ? k : mesh.vertex_of_file[k];
      if (vertex < on_vertex.size()) on_vertex[vertex] = std::max(on_vertex[vertex], values[k]);
    }
    return interpolate_vertex_values(surface, on_vertex);
  }
  if (values.size() == file_faces && on != "vertices") {
    std::vector<double> on_triangle(mesh.triangles.size());
    for (std::size_t t = 0; t < on_triangle.size(); ++t)
      on_triangle[t] = values[mesh.face_of_triangle.empty() ? t : mesh.face_of_triangle[t]];
    return spread_triangle_values(surface, on_triangle);
  }
  throw InputError(where,
                   fmt::format("{} values; the model has {} vertices and {} faces", values.size(),
                               file_vertices, file_faces),
                   "give one value for each vertex or one for each face of the model file, in its order");
}

}  // namespace verdigris
