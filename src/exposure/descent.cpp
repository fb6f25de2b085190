#include "descent.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace verdigris {

namespace {
constexpr double level = 1e-6;  // slopes below count as none: rounding of coordinates

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// Unit vector out of edge k.
glm::dvec2 outward(const Frame& frame, int k) {
  const glm::dvec2 d = frame.corner((k + 1) % 3) - frame.corner(k);
  const double length = glm::length(d);
  return length > 0.0 ? glm::dvec2(d.y, -d.x) / length : glm::dvec2(0.0, -1.0);
}
}  // namespace

Descent::Descent(const Surface& surface, glm::dvec3 up)
    : unfolding_(surface.frames(), surface.adjacency(), surface.barred_edges()) {
  for (const Frame& f : surface.frames()) {
    down_.push_back({-glm::dot(up, f.u), -glm::dot(up, f.v)});
    facing_.push_back(glm::dot(up, f.normal()));
  }
}

bool Descent::flat(std::uint32_t patch) const {
  return !(glm::length(down_[patch]) > level);
}

glm::dvec2 Descent::direction(std::uint32_t patch, double turn) const {
  const glm::dvec2 d = glm::normalize(down_[patch]);
  if (turn == 0.0) return d;
  const double c = std::cos(turn), s = std::sin(turn);
  return {c * d.x - s * d.y, s * d.x + c * d.y};
}

// The ways down from a corner of one triangle: along its two sides, or into it.
void Descent::consider(std::uint32_t patch, int corner, std::optional<Lower>& best) const {
  const Frame& f = unfolding_.frame(patch);
  const glm::dvec2 v = f.corner(corner),
                   to[2] = {f.corner((corner + 1) % 3) - v, f.corner((corner + 2) % 3) - v};
  const auto take = [&](double slope, int edge) {
    if (slope > level && (!best || slope > best->slope)) best = Lower{patch, corner, edge, slope};
  };
  if (!flat(patch)) {
    const glm::dvec2 d = direction(patch, 0.0);
    if (cross(to[0], d) > 0.0 && cross(d, to[1]) > 0.0) take(glm::length(down_[patch]), -1);
  }
  for (int side = 0; side < 2; ++side) {
    const double length = glm::length(to[side]);
    if (length > 0.0) take(glm::dot(down_[patch], to[side]) / length, side == 0 ? corner : (corner + 2) % 3);
  }
}

// The steepest way down from a vertex, among the triangles around it.
std::optional<Descent::Lower> Descent::lower_way(std::uint32_t patch, int corner, bool& open) const {
  std::optional<Lower> best;
  constexpr int most_triangles = 1000;
  consider(patch, corner, best);
  for (const bool counter_clockwise : {true, false}) {
    std::uint32_t at = patch;
    int c = corner;
    for (int n = 0; n < most_triangles; ++n) {
      const std::uint32_t across = unfolding_.across(at, counter_clockwise ? (c + 2) % 3 : c);
      if (across == Adjacency::none) {
        open = true;
        break;
      }
      at = across / 3;
      const int edge = unfolding_.frame_edge(across);
      c = counter_clockwise ? edge : (edge + 1) % 3;
      if (at == patch) return best;
      consider(at, c, best);
    }
  }
  return best;
}

Fall Descent::run(std::uint32_t patch, glm::dvec2 point, double length, double turn) const {
  Fall fall{Fall::End::way, patch, point, 0.0, false};
  int entered = -1;  // edge of the triangle that the way came in by
  int along = -1;    // edge it runs along, towards `end`
  int end = 0;
  bool straight = false;
  const auto done = [&](Fall::End how) {
    fall.end = how;
    return fall;
  };
  constexpr int most_turns = 10'000;
  for (int n = 0; n < most_turns; ++n) {
    const Frame& frame = unfolding_.frame(fall.patch);
    const double left = length - fall.length;
    if (along >= 0) {
      const glm::dvec2 way = frame.corner(end) - fall.point;
      const double distance = glm::length(way);
      if (distance > left) {
        fall.point += left / distance * way;
        fall.length = length;
        return done(Fall::End::way);
      }
      fall.point = frame.corner(end);
      fall.length += distance;
      bool open = false;
      const auto lower = lower_way(fall.patch, end, open);
      if (!lower) return done(open ? Fall::End::boundary : Fall::End::hollow);
      fall.patch = lower->patch;
      fall.point = unfolding_.frame(lower->patch).corner(lower->corner);
      along = lower->edge;
      end = along == lower->corner ? (along + 1) % 3 : along;
      entered = -1;
      straight = true;
      continue;
    }
    if (flat(fall.patch)) return done(Fall::End::hollow);
    const glm::dvec2 d = direction(fall.patch, straight ? 0.0 : turn);
    straight = false;
    int exit = -1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      const double rate = glm::dot(d, outward(frame, k));
      if (k == entered || !(rate > 1e-12)) continue;
      const double t = std::max(0.0, -beyond_edge(frame, k, fall.point)) / rate;
      if (t < nearest) nearest = t, exit = k;
    }
    if (exit < 0 || nearest >= left) {
      fall.point += left * d;
      fall.length = length;
      return done(Fall::End::way);
    }
    fall.point += nearest * d;
    fall.length += nearest;
    const std::uint32_t across = unfolding_.across(fall.patch, exit);
    if (across == Adjacency::none) return done(Fall::End::boundary);
    const std::uint32_t next = across / 3;
    const int edge = unfolding_.frame_edge(across);
    const Frame& other = unfolding_.frame(next);
    const glm::dvec2 there = unfold(frame, exit, other, edge)(fall.point);
    // Sharp: the faces turn by more than about 30 degrees.
    if (facing_[next] < -0.1 && facing_[fall.patch] > -0.1 && glm::dot(frame.normal(), other.normal()) < 0.87)
      fall.rim = true;
    fall.patch = next;
    fall.point = there;
    entered = edge;
    if (flat(next)) return done(Fall::End::hollow);
    if (glm::dot(direction(next, turn), outward(other, edge)) < -1e-9) continue;
    // Both slopes lead into the edge: the water runs along it.
    const double drop = glm::dot(down_[next], other.corner((edge + 1) % 3) - other.corner(edge));
    if (!(std::abs(drop) > level * glm::length(other.corner((edge + 1) % 3) - other.corner(edge))))
      return done(Fall::End::hollow);
    along = edge;
    end = drop > 0.0 ? (edge + 1) % 3 : edge;
  }
  return done(Fall::End::hollow);
}

}  // namespace verdigris
