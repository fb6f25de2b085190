#pragma once
// Rays against the triangles of a mesh.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// The triangles of a mesh, ready for rays from several threads at once. The mesh must outlive it.
///
/// Rays are traced in single precision, in units of the diagonal of the bounds about their centre; every
/// triangle decides for itself whether it is hit, so the answers depend neither on threads nor on order.
class RayScene {
 public:
  /// Throws std::runtime_error when Embree cannot start.
  explicit RayScene(const Mesh& mesh);

  /// How far to lift the start of a ray off the surface so that it does not meet its own triangle; model
  /// units.
  double lift() const { return 2e-5 / scale_; }
  /// Diagonal of the bounds, model units.
  double diagonal() const { return 1.0 / scale_; }

  /// Whether anything lies ahead.
  bool occluded(glm::dvec3 from, glm::dvec3 direction) const;

  struct Hit {
    std::uint32_t triangle;
    glm::dvec3 point;  ///< model space, on the triangle
  };
  /// The nearest thing ahead.
  std::optional<Hit> first(glm::dvec3 from, glm::dvec3 direction) const;

 private:
  struct Tree;
  struct Release {
    void operator()(Tree* tree) const;
  };
  const Mesh& mesh_;
  glm::dvec3 centre_{0.0};
  double scale_ = 1.0;
  std::unique_ptr<Tree, Release> tree_;
};

}  // namespace verdigris
