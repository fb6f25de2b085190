#include "verdigris/surface/walk.hpp"

#include <algorithm>
#include <cmath>

namespace verdigris {

double beyond_edge(const Frame& frame, int k, glm::dvec2 p) {
  if (k == 0) return -p.y;
  const glm::dvec2 a = frame.corner(k), b = frame.corner((k + 1) % 3);
  const glm::dvec2 d = b - a;
  const double length = std::sqrt(d.x * d.x + d.y * d.y);
  const double cross = d.y * (p.x - a.x) - d.x * (p.y - a.y);
  return length > 0.0 ? cross / length : 0.0;
}

int Unfolding::exit_edge(const Frame& frame, int entered, glm::dvec2 start, glm::dvec2 point) {
  // Rounding may push a point on an edge out by this much; crossing then would only go back and forth.
  const double slack = 1e-12 * frame.ab;
  int out[3], count = 0;
  for (int k = 0; k < 3; ++k)
    if (k != entered && beyond_edge(frame, k, point) > slack) out[count++] = k;
  if (count == 0) return -1;
  int exit = out[0];
  if (count == 2) {
    // Beyond two edges, so beyond the corner between them: on which side of it does the line pass?
    const bool wraps = out[0] == 0 && out[1] == 2;  // edges 2 and 0 meet at corner 0
    const int first = wraps ? 2 : out[0], second = wraps ? 0 : out[1];
    const glm::dvec2 v = frame.corner(second);
    const glm::dvec2 line = point - start, to_corner = v - start;
    // Counter-clockwise triangle: with the corner to the left of the line, the line leaves by the edge
    // before it.
    exit = line.x * to_corner.y - line.y * to_corner.x > 0.0 ? first : second;
  } else if (count == 3) {
    // Only a triangle of no area can be left by all three edges: take the one farthest out.
    for (int k = 1; k < 3; ++k)
      if (beyond_edge(frame, out[k], point) > beyond_edge(frame, exit, point)) exit = out[k];
  }
  return exit;
}

std::optional<Landing> Unfolding::walk(std::uint32_t patch, glm::dvec2 start, glm::dvec2 end,
                                       int most_crossings) const {
  Landing at{patch, end, {}};
  int entered = -1;
  for (int crossings = 0; crossings <= most_crossings; ++crossings) {
    const Frame& frame = frames_[at.patch];
    const int exit = exit_edge(frame, entered, start, at.point);
    if (exit < 0) return at;
    const std::uint32_t next = across(at.patch, exit);
    if (next == Adjacency::none) return std::nullopt;
    const std::uint32_t patch_next = next / 3;
    entered = frame_edge(next);
    const Motion m = unfold(frame, exit, frames_[patch_next], entered);
    at.point = m(at.point);
    start = m(start);
    at.motion = then(at.motion, m);
    at.patch = patch_next;
  }
  return std::nullopt;
}

Trace Unfolding::trace(std::uint32_t patch, glm::dvec2 start, glm::dvec2 end, int most_crossings) const {
  Trace trace;
  glm::dvec2 from = start;  // where the line came into this triangle; `start` is turned along with it
  int entered = -1;
  for (int crossings = 0;; ++crossings) {
    const Frame& frame = frames_[patch];
    const int exit = exit_edge(frame, entered, start, end);
    if (exit < 0) {
      trace.pieces.push_back({patch, from, end});
      return trace;
    }
    // Where the line meets the edge, kept between the edge's ends: rounding must not carry it past a corner.
    const glm::dvec2 a = frame.corner(exit), b = frame.corner((exit + 1) % 3), edge = b - a,
                     line = end - start;
    const double turn = edge.x * line.y - edge.y * line.x;
    const double along = turn != 0.0 ? ((start.x - a.x) * line.y - (start.y - a.y) * line.x) / turn : 0.5;
    const glm::dvec2 to = a + std::clamp(along, 0.0, 1.0) * edge;
    trace.pieces.push_back({patch, from, to});
    const std::uint32_t next = across(patch, exit);
    if (next == Adjacency::none || crossings == most_crossings) {
      trace.whole = false;
      return trace;
    }
    patch = next / 3;
    entered = frame_edge(next);
    const Motion m = unfold(frame, exit, frames_[patch], entered);
    from = m(to);
    start = m(start);
    end = m(end);
    trace.motion = then(trace.motion, m);
  }
}

}  // namespace verdigris
