#pragma once
// The plane of one input triangle: its corners in grid coordinates, and rigid motions between such planes.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace verdigris {

/// A rotation and a translation of the plane: p -> (c x - s y + tx, s x + c y + ty). Never a reflection.
struct Motion {
  double c = 1.0, s = 0.0, tx = 0.0, ty = 0.0;

  glm::dvec2 operator()(glm::dvec2 p) const { return {c * p.x - s * p.y + tx, s * p.x + c * p.y + ty}; }
  /// Turns a direction; the translation does not act on it.
  glm::dvec2 turn(glm::dvec2 d) const { return {c * d.x - s * d.y, s * d.x + c * d.y}; }
  /// First `first`, then `second`.
  friend Motion then(const Motion& first, const Motion& second) {
    const glm::dvec2 t = second({first.tx, first.ty});
    return {second.c * first.c - second.s * first.s, second.s * first.c + second.c * first.s, t.x, t.y};
  }
};

/// The oriented frame of an input triangle (Gobron & Chiba 1999, "Triangle Division"; axes exchanged so that
/// the longest edge AB lies along the rows): A = (0, 0), B = (ab, 0), C = (cx, cy), 0 <= cx <= ab, cy >= 0.
/// Counter-clockwise like the triangle itself, so `u x v` is its outward normal.
struct Frame {
  glm::dvec3 origin;          ///< A in model space
  glm::dvec3 u, v;            ///< unit vectors along the rows and across them
  double ab, cx, cy;          ///< model units
  std::uint8_t first_corner;  ///< corner of the input triangle that is A; B and C follow cyclically

  glm::dvec3 to_model(glm::dvec2 p) const { return origin + p.x * u + p.y * v; }
  glm::dvec2 to_plane(glm::dvec3 p) const;
  /// Corner k: 0 = A, 1 = B, 2 = C.
  glm::dvec2 corner(int k) const {
    return k == 0 ? glm::dvec2(0.0) : k == 1 ? glm::dvec2(ab, 0.0) : glm::dvec2(cx, cy);
  }
  glm::dvec3 normal() const;
};

/// The frame of triangle (a, b, c), the longest edge found (the first of equals). A triangle of no area gets
/// cy = 0 and any direction for v: it owns no cells, but walks can cross it.
Frame make_frame(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// The motion that lays the plane of `from` on that of `to`, with edge `from_edge` (corner k to k + 1 of
/// `from`) on edge `to_edge` of `to`, run the other way: the triangle turned about the shared edge until both
/// are flat.
Motion unfold(const Frame& from, int from_edge, const Frame& to, int to_edge);

}  // namespace verdigris
