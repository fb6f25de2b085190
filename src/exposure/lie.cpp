#include "verdigris/exposure/lie.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "at_cells.hpp"
#include "sample_mesh.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

CellNormals::CellNormals(const Surface& surface, double crease_angle) : surface_(surface) {
  const SampleMesh mesh(surface, crease_angle);
  corners_.reserve(3 * mesh.pieces().size());
  for (const SampleMesh::Piece& piece : mesh.pieces())
    for (const std::uint32_t s : piece.samples) corners_.push_back(mesh.samples()[s].normal);
}

glm::dvec3 CellNormals::at(std::size_t patch, glm::dvec2 point) const {
  const Frame& f = surface_.frame(patch);
  const glm::dvec3 w = corner_weights(f, point);
  const auto corner = [&](std::uint8_t k) { return corners_[3 * patch + (f.first_corner + k) % 3]; };
  const glm::dvec3 sum = w.x * corner(0) + w.y * corner(1) + w.z * corner(2);
  const double length = glm::length(sum);
  return length > 1e-9 ? sum / length : f.normal();
}

namespace {

glm::dvec3 unit(glm::dvec3 d) {
  const double length = glm::length(d);
  if (!(length > 0.0) || !std::isfinite(length))
    throw InputError("direction", "it has no length", "give three numbers that are not all 0");
  return d / length;
}

template <typename Value>
Field<float> filled(const Surface& surface, Value&& value) {
  Field<float> field = at_cells(surface, value);
  copy_to_ghosts(surface, field);
  return field;
}

}  // namespace

Field<float> height_above_origin(const Surface& surface, glm::dvec3 up) {
  up = unit(up);
  return filled(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    return glm::dot(surface.frame(patch).to_model(p), up);
  });
}

Field<float> height_mask(const Surface& surface, glm::dvec3 up) {
  up = unit(up);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const glm::uvec3& t : surface.mesh().triangles)
    for (int k = 0; k < 3; ++k) {
      const double h = glm::dot(surface.mesh().positions[t[k]], up);
      low = std::min(low, h);
      high = std::max(high, h);
    }
  return filled(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    const double h = glm::dot(surface.frame(patch).to_model(p), up);
    return high > low ? std::clamp((h - low) / (high - low), 0.0, 1.0) : 0.0;
  });
}

Field<float> slope_mask(const Surface& surface, glm::dvec3 up) {
  up = unit(up);
  const CellNormals normals(surface);
  return filled(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    return std::acos(std::clamp(glm::dot(normals.at(patch, p), up), -1.0, 1.0)) * 2.0 / std::numbers::pi;
  });
}

Field<float> facing_mask(const Surface& surface, glm::dvec3 towards, double sharpness) {
  towards = unit(towards);
  if (!(sharpness > 0.0)) throw InputError("sharpness", "it is not above 0", "use 1 for the cosine");
  const CellNormals normals(surface);
  return filled(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    const double cosine = std::clamp(glm::dot(normals.at(patch, p), towards), 0.0, 1.0);
    return sharpness == 1.0 ? cosine : std::pow(cosine, sharpness);
  });
}

glm::dvec3 parse_direction(std::string_view text, std::string_view where) {
  const auto fail = [&] {
    return InputError(std::string(where), fmt::format("'{}' is no direction", text),
                      "give three numbers, as in \"0 1 0\", or an axis: x, -x, y, -y, z, -z");
  };
  const bool minus = text.starts_with('-');
  const std::string_view axis = text.substr(minus ? 1 : 0);
  if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z') {
    glm::dvec3 d(0.0);
    d[axis[0] - 'x'] = minus ? -1.0 : 1.0;
    return d;
  }
  glm::dvec3 d(0.0);
  std::size_t at = 0;
  const auto gap = [&](bool comma) {
    while (at < text.size() && (text[at] == ' ' || text[at] == '\t' || (comma && text[at] == ','))) {
      comma = comma && text[at] != ',';
      ++at;
    }
  };
  for (int k = 0; k < 3; ++k) {
    gap(k > 0);
    const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), d[k]);
    if (error != std::errc() || !std::isfinite(d[k])) throw fail();
    at = static_cast<std::size_t>(end - text.data());
  }
  gap(false);
  if (at != text.size() || d == glm::dvec3(0.0)) throw fail();
  return d;
}

}  // namespace verdigris
