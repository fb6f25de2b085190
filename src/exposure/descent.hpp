#pragma once
// The steepest way down the triangles of a surface.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "verdigris/surface/surface.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris {

/// Where a way down led.
struct Fall {
  enum class End : std::uint8_t { way, hollow, boundary };
  End end = End::way;  ///< gone as far as asked, nothing lower around, or over an open edge
  std::uint32_t patch = 0;
  glm::dvec2 point{0.0};  ///< in the plane of `patch`
  double length = 0.0;    ///< model units
  bool rim = false;       ///< it turned a sharp edge on to an underside
};

class Descent {
 public:
  /// `up` is a unit vector. The surface must outlive it.
  Descent(const Surface& surface, glm::dvec3 up);

  /// From a point of `patch` for `length` model units, turned off the steepest direction by `turn` radians
  /// (less than a right angle) within triangles.
  Fall run(std::uint32_t patch, glm::dvec2 point, double length, double turn) const;

  /// Cosine of the normal to `up`: 1 level ground, -1 a level ceiling.
  double facing(std::uint32_t patch) const { return facing_[patch]; }

 private:
  struct Lower {
    std::uint32_t patch;
    int corner;  // of the frame, where the vertex is
    int edge;    // to run along, from the corner; -1: into the triangle
    double slope = 0.0;
  };
  bool flat(std::uint32_t patch) const;
  glm::dvec2 direction(std::uint32_t patch, double turn) const;
  std::optional<Lower> lower_way(std::uint32_t patch, int corner, bool& open) const;
  void consider(std::uint32_t patch, int corner, std::optional<Lower>& best) const;

  Unfolding unfolding_;
  std::vector<glm::dvec2> down_;  // [patch] drop by unit of length along the axes of its plane
  std::vector<double> facing_;    // [patch]
};

}  // namespace verdigris
