#include "verdigris/picture/contour.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace verdigris {

namespace {

constexpr double merge_distance = 1e-6;  // in cells: far below what shows, far above the rounding of t

// Crossings of one family of lines along one coordinate of the edge.
void cross(double from, double to, double h, double margin, bool rows, std::vector<ContourPoint>& points) {
  if (from == to) return;
  const auto [low, high] = std::minmax(from, to);
  const double first = std::ceil(low / h - 0.5), last = std::floor(high / h - 0.5);
  for (double k = first; k <= last; k += 1.0) {
    const double t = ((k + 0.5) * h - from) / (to - from);
    if (t > margin && t < 1.0 - margin) points.push_back({t, rows ? static_cast<std::int32_t>(k) : -1});
  }
}

}  // namespace

void edge_contour(const EdgeInPlane& own, const EdgeInPlane* across, double length, double cell_size,
                  std::vector<ContourPoint>& points) {
  if (!(length > 0.0)) return;
  const auto begin = static_cast<std::ptrdiff_t>(points.size());
  const double margin = merge_distance * cell_size / length;
  cross(own.from.y, own.to.y, cell_size, margin, true, points);
  cross(own.from.x, own.to.x, cell_size, margin, false, points);
  if (across) {
    cross(across->from.y, across->to.y, cell_size, margin, false, points);
    cross(across->from.x, across->to.x, cell_size, margin, false, points);
  }
  std::sort(points.begin() + begin, points.end(),
            [](const ContourPoint& a, const ContourPoint& b) { return a.t < b.t; });
  // A cluster lies at its least t, whichever side or line that comes from: both sides see the same multiset.
  auto kept = points.begin() + begin;
  for (auto p = kept; p != points.end(); ++p) {
    if (p != points.begin() + begin && p->t - kept->t <= margin) {
      if (p->row >= 0) kept->row = p->row;
    } else {
      if (p != points.begin() + begin) ++kept;
      *kept = *p;
    }
  }
  if (kept != points.end()) points.erase(kept + 1, points.end());
}

namespace {

EdgeInPlane edge_in_plane(const Frame& frame, int frame_edge, bool reversed) {
  const glm::dvec2 a = frame.corner(frame_edge), b = frame.corner((frame_edge + 1) % 3);
  return reversed ? EdgeInPlane{b, a} : EdgeInPlane{a, b};
}

}  // namespace

SharedEdge shared_edge(const Surface& surface, std::uint32_t patch, int frame_edge) {
  const Mesh& mesh = surface.mesh();
  const Frame& frame = surface.frame(patch);
  const int corner = (frame.first_corner + frame_edge) % 3;
  const glm::uvec3 triangle = mesh.triangles[patch];
  const std::uint32_t a = triangle[corner], b = triangle[(corner + 1) % 3];
  SharedEdge edge{};
  edge.reversed = a > b;
  edge.low = std::min(a, b);
  edge.high = std::max(a, b);
  edge.from = mesh.positions[edge.low];
  edge.to = mesh.positions[edge.high];
  edge.own = edge_in_plane(frame, frame_edge, edge.reversed);
  edge.across = surface.adjacency().opposite[3 * patch + static_cast<std::uint32_t>(corner)];
  if (edge.across != Adjacency::none) {
    const Frame& beyond = surface.frame(edge.across / 3);
    const int beyond_edge = (static_cast<int>(edge.across % 3) + 3 - beyond.first_corner) % 3;
    edge.other = edge_in_plane(beyond, beyond_edge, !edge.reversed);
  }
  return edge;
}

}  // namespace verdigris
