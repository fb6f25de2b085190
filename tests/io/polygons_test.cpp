// Faces of more than three corners.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "model_files.hpp"
#include "verdigris/mesh/report.hpp"

using namespace verdigris;
using namespace verdigris::model_files;

namespace {

Mesh read_polygon(const std::vector<glm::dvec3>& corners) {
  Polygons model{corners, {{}}};
  for (std::uint32_t i = 0; i < corners.size(); ++i) model.faces[0].push_back(i);
  return read("polygon.obj", obj(model));
}

/// Area with sign: triangles that run against `normal` count below zero, and would show up as a difference.
double signed_area(const Mesh& mesh, const glm::dvec3& normal) {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    twice += glm::dot(
        normal, glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0)));
  return twice / 2.0;
}

/// Covers the polygon once: the areas with and without sign are both the polygon's.
void expect_covered(const std::vector<glm::dvec3>& corners, double area, const glm::dvec3& normal) {
  const Mesh mesh = read_polygon(corners);
  EXPECT_EQ(mesh.triangles.size(), corners.size() - 2);
  EXPECT_NEAR(mesh_area(mesh), area, 1e-12 * area);
  EXPECT_NEAR(signed_area(mesh, normal), area, 1e-12 * area);
  const MeshReport report = inspect(mesh, make_adjacency(mesh));
  EXPECT_EQ(report.boundary_loops, 1u);
  EXPECT_EQ(report.degenerate_triangles, 0u);
}

TEST(Polygons, ConcaveQuadIsCutInside) {
  const std::vector<glm::dvec3> dart{{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < 4; ++i) corners.push_back(dart[(i + turn) % 4]);
    expect_covered(corners, 3.0, {0, 0, 1});
  }
}

TEST(Polygons, ConvexQuadIsCutAlongTheShorterDiagonal) {
  const Mesh mesh = read_polygon({{0, 0, 0}, {10, 1, 0}, {11, 3, 0}, {1, 2, 0}});  // 0-2 is longer than 1-3
  ASSERT_EQ(mesh.triangles.size(), 2u);
  const MeshReport report = inspect(mesh, make_adjacency(mesh));
  EXPECT_DOUBLE_EQ(report.longest_edge, std::sqrt(101.0));
}

TEST(Polygons, ConcaveShapesInAnyPlaneAndOrientation) {
  const std::vector<glm::dvec3> comb{{0, 0, 0}, {7, 0, 0}, {7, 3, 0}, {6, 3, 0}, {6, 1, 0},
                                     {5, 1, 0}, {5, 3, 0}, {4, 3, 0}, {4, 1, 0}, {3, 1, 0},
                                     {3, 3, 0}, {2, 3, 0}, {2, 1, 0}, {0, 1, 0}};
  const double area = 7.0 + 3 * 2.0;
  for (const glm::dvec3& u : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1), glm::dvec3(0.6, 0.8, 0)})
    for (const double side : {1.0, -1.0}) {
      const glm::dvec3 v = side * glm::normalize(glm::cross(u, glm::dvec3(0.48, -0.36, 0.8)));
      std::vector<glm::dvec3> corners;
      for (const glm::dvec3& p : comb) corners.push_back(glm::dvec3(100, -50, 20) + p.x * u + p.y * v);
      expect_covered(corners, area, glm::cross(u, v));
    }
}

TEST(Polygons, SpiralOfManyCorners) {
  std::vector<glm::dvec3> corners;
  constexpr int n = 150;
  for (int i = 0; i < n; ++i)
    corners.push_back({(1 + 0.1 * i) * std::cos(0.2 * i), (1 + 0.1 * i) * std::sin(0.2 * i), 0});
  for (int i = n - 1; i >= 0; --i) {
    const double r = 0.6 + 0.1 * i;
    corners.push_back({r * std::cos(0.2 * i), r * std::sin(0.2 * i), 0});
  }
  double twice = 0.0;  // the shoelace formula; the spiral winds outward, clockwise as listed
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  const Mesh mesh = read_polygon(corners);
  EXPECT_NEAR(mesh_area(mesh), std::abs(twice) / 2.0, 1e-9);
  EXPECT_NEAR(signed_area(mesh, {0, 0, 1}), twice / 2.0, 1e-9);
}

TEST(Polygons, CornersOnAStraightEdgeStay) {
  expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}, 4.0, {0, 0, 1});
  expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, 2.0, {0, 0, 1});
}

TEST(Polygons, RepeatedCornersAreSkipped) {
  const Mesh mesh = read("repeat.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 2 3 4 4\n");
  EXPECT_EQ(mesh.triangles.size(), 2u);
  expect_refused("point.obj", "v 0 0 0\nv 1 0 0\nf 1 2 2 1\n", "no triangle");
}

TEST(Polygons, RegularOnesOfManyCorners) {
  std::vector<glm::dvec3> corners;
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i) {
    const double a = 2.0 * std::numbers::pi * i / n;
    corners.push_back({0, std::cos(a), std::sin(a)});
  }
  expect_covered(corners, 0.5 * n * std::sin(2.0 * std::numbers::pi / n), {1, 0, 0});
}

TEST(Polygons, OfTooManyCornersAreRefused) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < 10001; ++i) (text += ' ') += std::to_string(i % 3 + 1);
  expect_refused("huge.obj", text, "10001 corners");
}

TEST(Polygons, KeepCornerAttributes) {
  const Mesh mesh = read(
      "uv.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
  ASSERT_EQ(mesh.corner_uv.size(), 6u);
  for (std::size_t c = 0; c < 6; ++c) {
    const glm::dvec3& p = mesh.corner(c / 3, static_cast<int>(c % 3));
    EXPECT_EQ(mesh.corner_uv[c], glm::vec2(p.x, p.y));
  }
}

}  // namespace
