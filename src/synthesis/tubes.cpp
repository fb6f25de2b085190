#include "verdigris/synthesis/tubes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>
#include <unordered_set>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

// Beyond this a mitre would grow without end; the tube ends and another begins.
constexpr double sharpest_cosine = -0.17364817766693033;  // of 100 degrees

// About 2 GB while it is made.
constexpr std::size_t most_vertices = 20'000'000;

struct Node {
  glm::dvec3 point;
  double radius;
};

glm::dvec3 any_across(const glm::dvec3& direction) {
  const glm::dvec3 axis = std::abs(direction.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
  return glm::normalize(glm::cross(direction, axis));
}

struct PositionHash {
  std::size_t operator()(const glm::vec3& p) const {
    std::uint32_t bits[3];
    std::uint64_t hash = 0;
    std::memcpy(bits, &p, sizeof bits);
    for (const std::uint32_t b : bits) hash = (hash ^ b ^ (hash >> 29)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

class TubeMaker {
 public:
  explicit TubeMaker(int sides) : sides_(static_cast<std::uint32_t>(sides)) {
    // A regular polygon of the area of the unit circle.
    const double n = sides;
    reach_ = std::sqrt(2.0 * std::numbers::pi / (n * std::sin(2.0 * std::numbers::pi / n)));
  }

  // A run of nodes without repeats or sharp bends.
  void add(std::span<const Node> nodes) {
    const std::size_t first = mesh.positions.size();
    if (first + nodes.size() * sides_ > most_vertices)
      throw InputError("tubes", fmt::format("more than {} vertices", most_vertices),
                       "use fewer iterations or sides");
    place_rings(nodes);
    join(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(nodes.size()));
  }

  Mesh mesh;

 private:
  void place_rings(std::span<const Node> nodes) {
    glm::dvec3 direction = glm::normalize(nodes[1].point - nodes[0].point);
    glm::dvec3 across = any_across(direction);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const glm::dvec3 next =
          k + 1 < nodes.size() ? glm::normalize(nodes[k + 1].point - nodes[k].point) : direction;
      // The ring lies in the plane that halves the bend; its points are moved there along the tube.
      const glm::dvec3 halving = direction + next;
      const glm::dvec3 aside = glm::cross(direction, across);
      for (std::uint32_t j = 0; j < sides_; ++j) {
        const double a = 2.0 * std::numbers::pi * j / sides_;
        const glm::dvec3 p = nodes[k].radius * reach_ * (std::cos(a) * across + std::sin(a) * aside);
        place(nodes[k].point, p - direction * (glm::dot(p, halving) / glm::dot(direction, halving)));
      }
      // The least rotation that takes `direction` to `next` (parallel transport): tubes do not twist.
      across -= 2.0 * glm::dot(across, halving) / glm::dot(halving, halving) * halving;
      across = glm::normalize(across - glm::dot(across, next) * next);
      direction = next;
    }
  }

  // Vertices at one position would be welded when the mesh is read, and tubes that touch there would no
  // longer be manifold: the later one moves inwards until it differs, in single precision too.
  void place(const glm::dvec3& centre, const glm::dvec3& offset) {
    double inwards = 1.0;
    for (int tries = 0; tries < 1000; ++tries, inwards -= 1.0 / 4096.0)
      if (taken_.insert(glm::vec3(centre + inwards * offset) + 0.0f).second) break;
    mesh.positions.push_back(centre + inwards * offset);
  }

  void join(std::uint32_t first, std::uint32_t rings) {
    const auto at = [&](std::uint32_t ring, std::uint32_t j) { return first + ring * sides_ + j % sides_; };
    for (std::uint32_t j = 1; j + 1 < sides_; ++j)
      mesh.triangles.push_back({at(0, 0), at(0, j + 1), at(0, j)});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
      for (std::uint32_t j = 0; j < sides_; ++j) {
        mesh.triangles.push_back({at(ring, j), at(ring, j + 1), at(ring + 1, j + 1)});
        mesh.triangles.push_back({at(ring, j), at(ring + 1, j + 1), at(ring + 1, j)});
      }
    for (std::uint32_t j = 1; j + 1 < sides_; ++j)
      mesh.triangles.push_back({at(rings - 1, 0), at(rings - 1, j), at(rings - 1, j + 1)});
  }

  std::uint32_t sides_;
  double reach_;
  std::unordered_set<glm::vec3, PositionHash> taken_;
};

}  // namespace

Mesh make_tubes(std::span<const TurtleLine> lines, const TubeOptions& options) {
  if (options.sides < 3 || options.sides > 64)
    throw InputError("tubes", "a tube has 3 to 64 sides", "choose a number between");
  TubeMaker maker(options.sides);
  std::vector<Node> nodes;
  const auto finish = [&] {
    if (nodes.size() > 1) maker.add(nodes);
    nodes.clear();
  };
  for (const TurtleLine& line : lines) {
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const Node node{line.points[k], 0.5 * line.widths[k]};
      if (!nodes.empty() && glm::distance(nodes.back().point, node.point) <= 1e-9 * node.radius) continue;
      if (nodes.size() > 1) {
        const glm::dvec3 before = glm::normalize(nodes.back().point - nodes[nodes.size() - 2].point);
        if (glm::dot(before, glm::normalize(node.point - nodes.back().point)) < sharpest_cosine) {
          const Node turn = nodes.back();
          finish();
          nodes.push_back(turn);
        }
      }
      nodes.push_back(node);
    }
    finish();
  }
  return std::move(maker.mesh);
}

double enclosed_volume(const Mesh& mesh) {
  // About a point of the mesh: the origin may be far away.
  const glm::dvec3 origin = mesh.positions.empty() ? glm::dvec3(0.0) : mesh.positions[0];
  double six = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    six += glm::dot(mesh.corner(t, 0) - origin,
                    glm::cross(mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin));
  return six / 6.0;
}

}  // namespace verdigris
