#include "verdigris/surface/surface_point.hpp"

#include <cmath>
#include <limits>

#include "nearest.hpp"
#include "nearest_on_triangle.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

SurfacePoint nearest_point(const Surface& surface, const glm::dvec3& p) {
  if (!std::isfinite(p.x + p.y + p.z))
    throw InputError("point", "its coordinates are not finite", "give three numbers in model units");
  const Mesh& mesh = surface.mesh();
  SurfacePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec3 on = nearest_on_triangle(p, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    const double distance = glm::length(p - on);
    // It is not a number for triangles with two corners in one place.
    if (!(distance < least)) continue;
    least = distance;
    best = {t, surface.frame(t).to_plane(on)};
  }
  return best;
}

std::optional<std::uint32_t> cell_at(const Surface& surface, const SurfacePoint& at) {
  const PatchRows rows{surface.rows(), surface.row_begins(), surface.owned_runs(), surface.cell_size()};
  const Unfolding unfolding(surface.frames(), surface.adjacency());
  const auto cell = nearest_cell(rows, unfolding, at.triangle, at.point, no_patch, 4.0, 4096);
  if (!cell) return std::nullopt;
  return cell->slot;
}

}  // namespace verdigris
