#pragma once
// Points of the surface by triangle, for what moves over it freely instead of from cell to cell.

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A point in the plane of its triangle's frame.
struct SurfacePoint {
  std::uint32_t triangle = 0;
  glm::dvec2 point{0.0};
};

/// The point of the surface nearest to `p`; of equally near ones that of the lowest triangle. Looks at every
/// triangle: for a few points. Throws InputError when `p` is not finite.
SurfacePoint nearest_point(const Surface& surface, const glm::dvec3& p);

/// The owned cell whose centre is nearest to a point, over edges too; nothing when no cell is near.
std::optional<std::uint32_t> cell_at(const Surface& surface, const SurfacePoint& at);

}  // namespace verdigris
