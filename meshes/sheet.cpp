#include "sheet.hpp"

#include <array>
#include <glm/vec2.hpp>
#include <map>
#include <utility>

#include "hash.hpp"

namespace verdigris::meshes {
namespace {

// Coordinates are whole thousandths, so that the Delaunay test is exact.
using Point = glm::i64vec2;
constexpr int scale = 1000;

/// Is `d` strictly inside the circle through a, b, c (counter-clockwise)?
bool in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = a - d, v = b - d, w = c - d;
  const auto square = [](const Point& p) { return p.x * p.x + p.y * p.y; };
  return square(u) * (v.x * w.y - v.y * w.x) - square(v) * (u.x * w.y - u.y * w.x) +
             square(w) * (u.x * v.y - u.y * v.x) >
         0;
}

/// Lawson's algorithm: flips edges until every one of them is Delaunay.
void flip_to_delaunay(const std::vector<Point>& points, std::vector<glm::uvec3>& triangles) {
  for (bool flipped = true; flipped;) {
    flipped = false;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<std::size_t, int>> edges;
    for (std::size_t t = 0; t < triangles.size() && !flipped; ++t) {
      for (int k = 0; k < 3 && !flipped; ++k) {
        const auto a = triangles[t][k], b = triangles[t][(k + 1) % 3], c = triangles[t][(k + 2) % 3];
        edges[{a, b}] = {t, k};
        const auto other = edges.find({b, a});
        if (other == edges.end()) continue;
        const auto [s, l] = other->second;
        const auto d = triangles[s][(l + 2) % 3];
        if (!in_circle(points[a], points[b], points[c], points[d])) continue;
        triangles[t] = {c, a, d};
        triangles[s] = {d, b, c};
        flipped = true;
      }
    }
  }
}

}  // namespace

Mesh make_sheet(int cells) {
  std::vector<Point> points;
  const int step = scale / cells;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const auto jitter = [&](int k, std::uint32_t seed) {  // less than a third of a cell, none on the border
        if (k == 0 || k == cells) return 0;
        const auto random = hash(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed);
        return static_cast<int>(random % static_cast<std::uint32_t>(2 * step / 3)) - step / 3;
      };
      points.emplace_back(i * step + jitter(i, 1), j * step + jitter(j, 2));
    }
  }
  Mesh mesh;
  for (const auto& point : points) mesh.positions.emplace_back(glm::dvec2(point) / double{scale}, 0.0);
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto at = static_cast<std::uint32_t>(j * (cells + 1) + i);
      const auto above = at + static_cast<std::uint32_t>(cells) + 1;
      mesh.triangles.emplace_back(at, at + 1, above + 1);
      mesh.triangles.emplace_back(at, above + 1, above);
    }
  }
  flip_to_delaunay(points, mesh.triangles);
  return mesh;
}

}  // namespace verdigris::meshes
