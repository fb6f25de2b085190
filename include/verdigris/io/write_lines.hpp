#pragma once
// Polylines out: for viewers, for other programs, and for paper.

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace verdigris {

/// A line through points, as wide as it is at each.
struct Polyline {
  std::vector<glm::dvec3> points;
  std::vector<double> widths;           ///< [point]
  std::vector<std::int32_t> triangles;  ///< [point] of the model it lies on; empty: on none
  std::int32_t generation = 0;          ///< how many branchings lie before it
};

/// VTK polylines (.vtp), binary: point arrays `width` and `triangle` (-1: none), line array `generation`. All
/// writers throw InputError when the file cannot be written, and leave none half written.
void write_lines_vtp(const std::filesystem::path& file, std::span<const Polyline> lines);

/// Wavefront OBJ with `l` elements, in full precision.
void write_lines_obj(const std::filesystem::path& file, std::span<const Polyline> lines);

/// A drawing of the lines seen along -z, y upwards, about 1000 units across; width as it is at each piece.
void write_lines_svg(const std::filesystem::path& file, std::span<const Polyline> lines);

}  // namespace verdigris
