#pragma once
// Shapes whose masks are known.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "shapes.hpp"
#include "verdigris/surface/surface.hpp"

namespace shapes {

/// An octahedron halved `times` times and blown up: 8 * 4^times triangles.
inline Mesh round_sphere(double radius, int times) {
  Mesh m;
  m.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  m.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int n = 0; n < times; ++n) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, fresh] = middle.try_emplace({std::min(a, b), std::max(a, b)},
                                                  static_cast<std::uint32_t>(m.positions.size()));
      if (fresh) m.positions.push_back(glm::normalize(m.positions[a] + m.positions[b]));
      return at->second;
    };
    std::vector<glm::uvec3> finer;
    for (const glm::uvec3& t : m.triangles) {
      const auto a = between(t[0], t[1]), b = between(t[1], t[2]), c = between(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {a, t[1], b}, {c, b, t[2]}, {a, b, c}});
    }
    m.triangles = std::move(finer);
  }
  for (glm::dvec3& p : m.positions) p *= radius;
  return m;
}

/// Floor x in [0, width], y in [-half, half] at z = 0 and a wall at x = 0 of height `height`, both seen from
/// inside the right angle.
inline Mesh right_angle(double width, double half, double height) {
  Mesh m;
  m.positions = {{0, -half, 0}, {width, -half, 0},  {width, half, 0},
                 {0, half, 0},  {0, -half, height}, {0, half, height}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}};
  return m;
}

/// Floor x and y in [0, size] at z = 0 and walls at x = 0 and y = 0 of height `height`, seen from inside.
inline Mesh room_corner(double size, double height) {
  Mesh m;
  m.positions = {{0, 0, 0},      {size, 0, 0},      {size, size, 0},  {0, size, 0},
                 {0, 0, height}, {0, size, height}, {size, 0, height}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}, {0, 4, 6}, {0, 6, 1}};
  return m;
}

inline Mesh turned_inside_out(Mesh m) {
  for (glm::uvec3& t : m.triangles) std::swap(t[1], t[2]);
  return m;
}

inline verdigris::Surface with_cells(Mesh mesh, double cells) {
  const double size = verdigris::cell_size_for(mesh, cells);
  return verdigris::make_surface(std::move(mesh), {.cell_size = size});
}

/// visit(slot) for every owned cell, until an assertion fails.
template <typename Visit>
void each_cell(const verdigris::Surface& surface, Visit&& visit) {
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot) {
      visit(slot);
      if (::testing::Test::HasFatalFailure()) return;
    }
}

}  // namespace shapes
