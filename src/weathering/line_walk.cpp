#include "line_walk.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace verdigris::weathering {

LineWalk::LineWalk(const Surface& surface, const Unfolding& unfolding, std::uint32_t slot, double angle)
    : surface_(surface), unfolding_(unfolding), heading_(std::cos(angle), std::sin(angle)) {
  const CellRef cell = surface.cell(slot);
  at_ = {cell.patch, surface.centre(cell.row, cell.column)};
}

bool LineWalk::forward(double distance) {
  const Trace trace = unfolding_.trace(at_.triangle, at_.point, at_.point + distance * heading_);
  at_ = {trace.pieces.back().patch, trace.pieces.back().to};
  heading_ = trace.motion.turn(heading_);
  return trace.whole;
}

void LineWalk::turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  heading_ = {c * heading_.x - s * heading_.y, s * heading_.x + c * heading_.y};
}

void LineWalk::steer(const glm::dvec3& towards, double most) {
  const Frame& frame = surface_.frame(at_.triangle);
  const glm::dvec2 aim(glm::dot(towards, frame.u), glm::dot(towards, frame.v));
  if (!(glm::length(aim) > 1e-12)) return;
  const double angle =
      std::atan2(heading_.x * aim.y - heading_.y * aim.x, heading_.x * aim.x + heading_.y * aim.y);
  turn(std::clamp(angle, -most, most));
}

}  // namespace verdigris::weathering
