#pragma once
// A tip that moves over the surface in short straight steps and leaves a line of cells.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "verdigris/surface/surface_point.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris::weathering {

class LineWalk {
 public:
  /// Begins at the centre of an owned cell, heading at `angle` from the rows of its patch.
  LineWalk(const Surface& surface, const Unfolding& unfolding, std::uint32_t slot, double angle);

  /// Goes on by `distance`; false when it met a boundary or barrier.
  bool forward(double distance);
  void turn(double angle);
  /// Turns towards a direction in model space by at most `most` radians.
  void steer(const glm::dvec3& towards, double most);

  std::optional<std::uint32_t> cell() const { return cell_at(surface_, at_); }
  glm::dvec3 position() const { return surface_.frame(at_.triangle).to_model(at_.point); }
  glm::dvec3 heading() const {
    const Frame& frame = surface_.frame(at_.triangle);
    return heading_.x * frame.u + heading_.y * frame.v;
  }

 private:
  const Surface& surface_;
  const Unfolding& unfolding_;
  SurfacePoint at_;
  glm::dvec2 heading_;
};

}  // namespace verdigris::weathering
