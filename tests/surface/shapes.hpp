#pragma once
// Shapes that a test can reason about, built in a few lines.

#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>

#include "verdigris/mesh/mesh.hpp"

namespace shapes {

using verdigris::Mesh;

inline Mesh triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  return {{a, b, c}, {{0, 1, 2}}, {}, {}, {}, {}};
}

/// Two triangles with the longest edge in common.
inline Mesh square(double side) {
  return {{{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}, {}};
}

/// One triangle so large that a disc of `radius` about the origin does not touch its edges.
inline Mesh plain(double radius) {
  return triangle({-4 * radius, -1.5 * radius, 0}, {4 * radius, -1.5 * radius, 0}, {0, 3.0 * radius, 0});
}

inline Mesh cube(double side) {
  Mesh m;
  for (int k = 0; k < 8; ++k) m.positions.push_back(side * glm::dvec3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
  m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return m;
}

/// A grid of quads over a parameter domain, wrapped where asked; `at(i, j)` gives the vertices.
template <typename At>
Mesh grid(int columns, int rows, bool wrap_columns, bool wrap_rows, At&& at) {
  Mesh m;
  const int nc = columns + !wrap_columns, nr = rows + !wrap_rows;
  for (int j = 0; j < nr; ++j)
    for (int i = 0; i < nc; ++i) m.positions.push_back(at(i, j));
  const auto id = [&](int i, int j) { return static_cast<std::uint32_t>(j % nr * nc + i % nc); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      m.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      m.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return m;
}

inline Mesh torus(double major, double minor, int columns, int rows) {
  return grid(columns, rows, true, true, [=](int i, int j) {
    const double a = 2.0 * std::numbers::pi * i / columns, b = 2.0 * std::numbers::pi * j / rows;
    const double r = major + minor * std::cos(b);
    return glm::dvec3(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
  });
}

/// The paper's worst case: a thin cylinder of long, thin triangles, along z.
inline Mesh cylinder(double radius, double length, int sides) {
  return grid(sides, 1, true, false, [=](int i, int j) {
    const double a = 2.0 * std::numbers::pi * i / sides;
    return glm::dvec3(radius * std::cos(a), radius * std::sin(a), length * j);
  });
}

/// Turns the diagonal of each square of a grid, by chance.
inline void flip_diagonals(Mesh& m, std::mt19937& engine) {
  for (std::size_t q = 0; q < m.triangles.size(); q += 2)
    if (engine() & 1u) {
      const auto a = m.triangles[q][0], b = m.triangles[q][1], c = m.triangles[q][2],
                 d = m.triangles[q + 1][2];
      m.triangles[q] = {a, b, d};
      m.triangles[q + 1] = {b, c, d};
    }
}

/// A flat random triangulation about the origin: a square grid of side `spacing`, jittered, random diagonals,
/// turned by an angle of its own, so that no two frames agree.
inline Mesh random_plane(double spacing, double radius, unsigned seed) {
  std::mt19937 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0 - 0.5; };
  const int n = static_cast<int>(2.0 * radius / spacing) + 4;
  const double turn = 0.37 + seed;
  Mesh m = grid(n, n, false, false, [&](int i, int j) {
    const double x = (i - n / 2 + 0.5 * uniform()) * spacing, y = (j - n / 2 + 0.5 * uniform()) * spacing;
    return glm::dvec3(x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn), 0.0);
  });
  flip_diagonals(m, engine);
  return m;
}

}  // namespace shapes
