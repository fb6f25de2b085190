#pragma once
// Shapes of few triangles whose properties are known.

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::shapes {

inline Mesh mesh_of(std::initializer_list<glm::dvec3> positions,
                    std::initializer_list<glm::uvec3> triangles) {
  Mesh mesh;
  mesh.positions = positions;
  mesh.triangles = triangles;
  return mesh;
}

inline Mesh triangle() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
}

inline Mesh square() {
  return mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
}

/// Closed, outward, volume 1/6, area (3 + sqrt 3) / 2.
inline Mesh tetrahedron() {
  return mesh_of({{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
}

/// A strip of `n` quads round the z axis, turned by half turns: none gives a cylinder, one a Moebius strip.
inline Mesh strip(std::uint32_t n, int half_turns) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * i / n, b = 0.5 * half_turns * a;
    for (const double side : {-0.25, 0.25}) {
      const double r = 1.0 + side * std::sin(b);
      mesh.positions.push_back({r * std::cos(a), r * std::sin(a), side * std::cos(b)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    std::uint32_t c = 2 * i + 2, d = 2 * i + 3;
    if (i + 1 == n) {
      c = half_turns % 2 ? 1 : 0;
      d = half_turns % 2 ? 0 : 1;
    }
    mesh.triangles.push_back({2 * i, c, d});
    mesh.triangles.push_back({2 * i, d, 2 * i + 1});
  }
  return mesh;
}

/// Closed, of n * m quads cut in two: 2nm triangles, 3nm edges, nm vertices.
inline Mesh torus(std::uint32_t n, std::uint32_t m) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = 2.0 * std::numbers::pi * i / n, v = 2.0 * std::numbers::pi * j / m;
      const double r = 2.0 + std::cos(v);
      mesh.positions.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  auto at = [=](std::uint32_t i, std::uint32_t j) { return (i % n) * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Both in one mesh, without a common vertex.
inline Mesh together(Mesh a, const Mesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const glm::uvec3& t : b.triangles) a.triangles.push_back(t + shift);
  return a;
}

inline void flip(Mesh& mesh, std::size_t t) {
  std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
}

}  // namespace verdigris::shapes
