#include "solids.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>

namespace verdigris::meshes {
namespace {

glm::dvec3 on_circle(double radius, double y, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), y, -radius * std::sin(angle)};
}

}  // namespace

Mesh make_cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5);
  constexpr std::array<glm::uvec4, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces) {
    mesh.triangles.emplace_back(face[0], face[1], face[2]);
    mesh.triangles.emplace_back(face[0], face[2], face[3]);
  }
  return mesh;
}

Mesh make_sphere(int splits) {
  Mesh mesh;
  const double g = (1 + std::sqrt(5.0)) / 2;
  mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                    {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (auto& position : mesh.positions) position = glm::normalize(position);
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int split = 0; split < splits; ++split) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return found->second;
    };
    std::vector<glm::uvec3> finer;
    for (const auto& t : mesh.triangles) {
      const auto xy = middle(t.x, t.y), yz = middle(t.y, t.z), zx = middle(t.z, t.x);
      finer.insert(finer.end(), {{t.x, xy, zx}, {t.y, yz, xy}, {t.z, zx, yz}, {xy, yz, zx}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

Mesh make_torus(double major, double minor, int around, int across) {
  Mesh mesh;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double angle = 2 * std::numbers::pi * j / across;
      mesh.positions.push_back(on_circle(major + minor * std::cos(angle), minor * std::sin(angle),
                                         static_cast<double>(i) / around));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i % around * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  }
  return mesh;
}

Mesh make_cylinder(double radius, double length, int sides) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(sides);
  for (const double y : {0.0, length}) {
    for (int i = 0; i < sides; ++i)
      mesh.positions.push_back(on_circle(radius, y, static_cast<double>(i) / sides));
  }
  mesh.positions.emplace_back(0.0, 0.0, 0.0);
  mesh.positions.emplace_back(0.0, length, 0.0);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.triangles.emplace_back(i, next, count + next);
    mesh.triangles.emplace_back(i, count + next, count + i);
    mesh.triangles.emplace_back(2 * count, next, i);
    mesh.triangles.emplace_back(2 * count + 1, count + i, count + next);
  }
  return mesh;
}

Mesh make_vase() {
  struct Pentagon {
    double radius, y, turns;
  };
  // Foot, belly, neck, lip, throat: each turned by a tenth against the one before.
  constexpr std::array<Pentagon, 5> pentagons{
      {{0.42, 0.0, 0.0}, {0.80, 0.62, 0.1}, {0.36, 1.28, 0.2}, {0.66, 1.72, 0.3}, {0.22, 1.20, 0.4}}};
  Mesh mesh;
  for (const auto& pentagon : pentagons) {
    for (int i = 0; i < 5; ++i)
      mesh.positions.push_back(on_circle(pentagon.radius, pentagon.y, pentagon.turns + i / 5.0));
  }
  mesh.positions.emplace_back(0.0, 0.0, 0.0);
  mesh.positions.emplace_back(0.0, 0.45, 0.0);
  const auto at = [](int ring, int i) { return static_cast<std::uint32_t>(5 * ring + (i + 5) % 5); };
  for (int i = 0; i < 5; ++i) {
    mesh.triangles.emplace_back(25, at(0, i + 1), at(0, i));
    for (int ring = 0; ring < 4; ++ring) {
      mesh.triangles.emplace_back(at(ring, i), at(ring, i + 1), at(ring + 1, i));
      mesh.triangles.emplace_back(at(ring, i), at(ring + 1, i), at(ring + 1, i - 1));
    }
    mesh.triangles.emplace_back(26, at(4, i), at(4, i + 1));
  }
  return mesh;
}

}  // namespace verdigris::meshes
