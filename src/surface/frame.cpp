#include "verdigris/surface/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace verdigris {

glm::dvec2 Frame::to_plane(glm::dvec3 p) const {
  const glm::dvec3 d = p - origin;
  return {glm::dot(d, u), glm::dot(d, v)};
}

glm::dvec3 Frame::normal() const {
  return glm::cross(u, v);
}

Frame make_frame(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 corner[3] = {a, b, c};
  const glm::dvec3 side[3] = {b - a, c - b, a - c};
  std::uint8_t longest = 0;
  for (std::uint8_t k = 1; k < 3; ++k)
    if (glm::dot(side[k], side[k]) > glm::dot(side[longest], side[longest])) longest = k;

  Frame f{};
  f.first_corner = longest;
  f.origin = corner[longest];
  f.ab = std::sqrt(glm::dot(side[longest], side[longest]));
  f.u = f.ab > 0.0 ? side[longest] / f.ab : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 ac = corner[(longest + 2) % 3] - f.origin;
  f.cx = std::clamp(glm::dot(ac, f.u), 0.0, f.ab);
  // The part of AC across AB. Below rounding of the coordinates it is noise, not a direction.
  glm::dvec3 across = ac - glm::dot(ac, f.u) * f.u;
  f.cy = std::sqrt(glm::dot(across, across));
  const double noise = 1e-12 * f.ab;
  if (f.cy > noise) {
    f.v = across / f.cy;
    // Once more, so that u and v are orthogonal to the last bits for slivers too.
    f.v -= glm::dot(f.v, f.u) * f.u;
    f.v /= std::sqrt(glm::dot(f.v, f.v));
  } else {
    f.cy = 0.0;
    const glm::dvec3 axis = std::abs(f.u.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    f.v = axis - glm::dot(axis, f.u) * f.u;
    f.v /= std::sqrt(glm::dot(f.v, f.v));
  }
  return f;
}

Motion unfold(const Frame& from, int from_edge, const Frame& to, int to_edge) {
  const glm::dvec2 p0 = from.corner(from_edge), p1 = from.corner((from_edge + 1) % 3);
  const glm::dvec2 q0 = to.corner(to_edge), q1 = to.corner((to_edge + 1) % 3);
  const glm::dvec2 p = p1 - p0, q = q0 - q1;  // p0 comes to lie on q1, p1 on q0
  Motion m;
  m.c = p.x * q.x + p.y * q.y;
  m.s = p.x * q.y - p.y * q.x;
  const double length = std::sqrt(m.c * m.c + m.s * m.s);
  if (length > 0.0) {
    m.c /= length;
    m.s /= length;
  } else {
    m.c = 1.0;
    m.s = 0.0;
  }
  // The middles of the edge coincide: rounding is shared between its ends.
  const glm::dvec2 pm = 0.5 * (p0 + p1), qm = 0.5 * (q0 + q1), turned = m.turn(pm);
  m.tx = qm.x - turned.x;
  m.ty = qm.y - turned.y;
  return m;
}

}  // namespace verdigris
