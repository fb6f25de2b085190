#include "verdigris/picture/normals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace verdigris {

namespace {

constexpr std::uint32_t next(std::uint32_t half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
constexpr std::uint32_t previous(std::uint32_t half_edge) {
  return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1;
}

// Corner k of a triangle and the half-edge that leaves it share a number.
class Fans {
 public:
  Fans(const Mesh& mesh, const Adjacency& adjacency, double crease_angle)
      : mesh_(mesh), adjacency_(adjacency), least_cosine_(std::cos(crease_angle * std::numbers::pi / 180.0)) {
    faces_.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const glm::dvec3 n =
          glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
      const double length = glm::length(n);
      faces_.push_back(length > 0.0 ? n / length : glm::dvec3(0.0));
    }
  }

  const glm::dvec3& face(std::uint32_t corner) const { return faces_[corner / 3]; }

  // The same vertex's corner in the triangle across the half-edge that leaves it, or across the one that
  // enters it.
  std::uint32_t clockwise(std::uint32_t corner) const {
    const std::uint32_t across = smooth(corner);
    return across == Adjacency::none ? across : next(across);
  }
  std::uint32_t counter_clockwise(std::uint32_t corner) const { return smooth(previous(corner)); }

  double angle(std::uint32_t corner) const {
    const std::size_t t = corner / 3;
    const int k = static_cast<int>(corner % 3);
    const glm::dvec3 p = mesh_.corner(t, k);
    const glm::dvec3 a = mesh_.corner(t, (k + 1) % 3) - p, b = mesh_.corner(t, (k + 2) % 3) - p;
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
  }

 private:
  std::uint32_t smooth(std::uint32_t half_edge) const {
    const std::uint32_t across = adjacency_.opposite[half_edge];
    if (across == Adjacency::none) return across;
    const glm::dvec3 &a = face(half_edge), &b = face(across);
    const bool flat = a == glm::dvec3(0.0) || b == glm::dvec3(0.0);
    return flat || glm::dot(a, b) >= least_cosine_ - 1e-12 ? across : Adjacency::none;
  }

  const Mesh& mesh_;
  const Adjacency& adjacency_;
  double least_cosine_;
  std::vector<glm::dvec3> faces_;
};

}  // namespace

std::vector<glm::vec3> corner_normals(const Mesh& mesh, const Adjacency& adjacency, double crease_angle) {
  const Fans fans(mesh, adjacency, crease_angle);
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  std::vector<glm::vec3> normals(corners);
  std::vector<bool> done(corners, false);
  std::vector<std::uint32_t> fan;
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    if (done[corner]) continue;
    // Each smooth fan is walked once, from its clockwise end, so that a vertex of n triangles costs n and not
    // n squared.
    std::uint32_t first = corner;
    for (std::uint32_t c = fans.clockwise(first); c != Adjacency::none && c != corner; c = fans.clockwise(c))
      first = c;
    fan.clear();
    glm::dvec3 sum(0.0);
    for (std::uint32_t c = first; c != Adjacency::none && !done[c]; c = fans.counter_clockwise(c)) {
      done[c] = true;
      fan.push_back(c);
      sum += fans.angle(c) * fans.face(c);
    }
    const double length = glm::length(sum);
    for (const std::uint32_t c : fan) {
      const glm::dvec3 n = length > 1e-9 ? sum / length : fans.face(c);
      normals[c] = n == glm::dvec3(0.0) ? glm::vec3(0.0f, 0.0f, 1.0f) : glm::vec3(n);
    }
  }
  return normals;
}

}  // namespace verdigris
