#pragma once
// One triangle rebuilt from triangle strips and fans whose vertices are cell centres as far as possible.
// Source: Gobron & Chiba 1999, "Triangle Strips and Triangle Fans", Figs 11 and 12.

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "verdigris/surface/frame.hpp"

namespace verdigris {

/// Strips and fans as OpenGL draws them: indices, the primitives separated by `restart`.
struct BandIndices {
  static constexpr std::uint32_t restart = 0xFFFFFFFFu;
  std::vector<std::uint32_t> strips, fans;
};

/// A point of the contour inside an edge, in grid coordinates of the patch.
struct OutlinePoint {
  glm::dvec2 p;
  std::int32_t row;  ///< grid row whose centred line ends here, or -1
};

/// The contour of a patch without its corners: along AB from A, along BC from B, along AC from A.
/// Vertices are numbered A, B, C = 0, 1, 2, then ab, bc, ac in order, then the cell centres row by row.
struct Outline {
  std::vector<OutlinePoint> ab, bc, ac;
  std::uint32_t size() const { return static_cast<std::uint32_t>(3 + ab.size() + bc.size() + ac.size()); }
};

/// Columns [begin, end) of one grid row.
struct ColumnRun {
  std::int32_t begin = 0, end = 0;
};

/// A centred line between two points of the contour, and the cell centres on it.
struct BandLine {
  std::int32_t row;
  std::uint32_t left, right;  ///< positions in Outline::ac and Outline::bc
  ColumnRun columns;          ///< cell centres strictly between the two, further than 1e-4 cells from them
};

/// The lines of a patch from below; `owned` [grid row] limits the centres (a row beyond its end has none).
void band_lines(const Outline& outline, double cell_size, std::span<const ColumnRun> owned,
                std::vector<BandLine>& lines);

/// Appends bands first <= k < last, of `lines.size() + 1` in all: band 0 lies between AB and the first line
/// (half a cell high), band k between lines k - 1 and k, the last one between the last line and C.
///
/// `base` is added to contour vertices; the centres of line k are numbered on from `line_vertex[k]`. Each
/// band is convex: strips, and fans where one side has several points to one of the other.
/// All triangles are counter-clockwise, cover the bands exactly, and have no angle of 180 degrees.
void triangulate_bands(const Frame& frame, double cell_size, const Outline& outline,
                       std::span<const BandLine> lines, std::span<const std::uint32_t> line_vertex,
                       std::size_t first, std::size_t last, std::uint32_t base, BandIndices& indices);

/// The triangles of strips and fans, three indices each.
std::vector<std::uint32_t> triangles_of(const BandIndices& indices);

}  // namespace verdigris
