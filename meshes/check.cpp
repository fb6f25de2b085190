#include "check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace verdigris::meshes {
namespace {

using HalfEdges = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;  // (from, to) -> triangle

HalfEdges half_edges(const Mesh& mesh) {
  HalfEdges edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto from = mesh.triangles[t][k], to = mesh.triangles[t][(k + 1) % 3];
      if (!edges.emplace(std::pair{from, to}, t).second) {
        throw std::runtime_error(fmt::format("edge {} -> {} belongs to two triangles", from, to));
      }
    }
  }
  return edges;
}

/// Disjoint sets that can only grow together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t i) const { return parent_[i] == i ? i : find(parent_[i]); }
  void unite(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }
  std::size_t count() const {
    std::size_t roots = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) roots += parent_[i] == i ? 1 : 0;
    return roots;
  }

 private:
  std::vector<std::size_t> parent_;
};

/// Corners that share a vertex and an edge at it are one group: a manifold has one group a vertex.
void require_one_fan_a_vertex(const Mesh& mesh, const HalfEdges& edges) {
  const auto corner_of = [&](std::size_t triangle, std::uint32_t vertex) {
    std::size_t k = 0;
    while (mesh.triangles[triangle][static_cast<int>(k)] != vertex) ++k;
    return 3 * triangle + k;
  };
  Groups fans(3 * mesh.triangles.size());
  for (const auto& [edge, triangle] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other == edges.end()) continue;
    fans.unite(corner_of(triangle, edge.first), corner_of(other->second, edge.first));
    fans.unite(corner_of(triangle, edge.second), corner_of(other->second, edge.second));
  }
  if (fans.count() != mesh.positions.size()) {
    throw std::runtime_error(
        fmt::format("{} fans of triangles round {} vertices", fans.count(), mesh.positions.size()));
  }
}

double least_angle(const Mesh& mesh, std::size_t triangle) {
  double least = std::numbers::pi;
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 at = mesh.corner(triangle, k);
    const glm::dvec3 u = mesh.corner(triangle, (k + 1) % 3) - at, v = mesh.corner(triangle, (k + 2) % 3) - at;
    least = std::min(least, std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v)));
  }
  return least * 180 / std::numbers::pi;
}

bool share_vertex(const glm::uvec3& a, const glm::uvec3& b) {
  for (int i = 0; i < 3; ++i) {
    if (b[i] == a.x || b[i] == a.y || b[i] == a.z) return true;
  }
  return false;
}

/// Does the open segment pq pass through the inside of the triangle?
bool crosses(const glm::dvec3& p, const glm::dvec3& q, const Mesh& mesh, std::size_t triangle) {
  const auto side = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    return glm::dot(glm::cross(b - a, c - a), d - a);
  };
  const glm::dvec3 &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1),
                   &c = mesh.corner(triangle, 2);
  if (side(a, b, c, p) * side(a, b, c, q) >= 0) return false;
  const double ab = side(p, q, a, b), bc = side(p, q, b, c), ca = side(p, q, c, a);
  return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

void require_no_crossing(const Mesh& mesh) {
  struct Box {
    glm::dvec3 lower, upper;
  };
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    boxes.push_back({glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))});
  }
  for (std::size_t s = 0; s < boxes.size(); ++s) {
    for (std::size_t t = 0; t < boxes.size(); ++t) {
      if (glm::any(glm::lessThan(boxes[s].upper, boxes[t].lower)) ||
          glm::any(glm::lessThan(boxes[t].upper, boxes[s].lower)) ||
          share_vertex(mesh.triangles[s], mesh.triangles[t])) {
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        if (crosses(mesh.corner(s, k), mesh.corner(s, (k + 1) % 3), mesh, t)) {
          throw std::runtime_error(fmt::format("triangles {} and {} cross", s, t));
        }
      }
    }
  }
}

}  // namespace

Shape inspect(const Mesh& mesh) {
  const HalfEdges edges = half_edges(mesh);
  Shape shape{.triangles = mesh.triangles.size(), .least_angle = 180};
  Groups pieces(mesh.triangles.size());
  for (const auto& [edge, triangle] : edges) {
    const auto other = edges.find({edge.second, edge.first});
    if (other == edges.end()) {
      ++shape.boundary_edges;
    } else {
      pieces.unite(triangle, other->second);
    }
  }
  require_one_fan_a_vertex(mesh, edges);
  require_no_crossing(mesh);
  shape.pieces = pieces.count();
  const std::size_t edge_count = (edges.size() + shape.boundary_edges) / 2;
  shape.euler =
      static_cast<long>(mesh.positions.size() + mesh.triangles.size()) - static_cast<long>(edge_count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    shape.area += glm::length(glm::cross(b - a, c - a)) / 2;
    shape.volume += glm::dot(a, glm::cross(b, c)) / 6;
    shape.least_angle = std::min(shape.least_angle, least_angle(mesh, t));
  }
  if (!(shape.least_angle > 0.01)) throw std::runtime_error("a triangle without area");
  return shape;
}

}  // namespace verdigris::meshes
