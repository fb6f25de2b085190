// Lines on the surface brought to its cells.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_set>

#include "verdigris/base/error.hpp"
#include "verdigris/exposure/surface_turtle.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris {

namespace {

// Calls visit(place, direction, width, length so far) at `first`, `first + spacing`, ... along a line.
template <typename Visit>
void sample(const Surface& surface, const SurfaceLine& line, double spacing, Visit&& visit) {
  double next = 0.0, length = 0.0;
  for (std::size_t k = 1; k < line.points.size(); ++k) {
    // Point k - 1 as seen from the triangle of point k: on the edge between, or in the same triangle.
    const SurfacePoint& to = line.points[k];
    const glm::dvec2 from = line.points[k - 1].triangle == to.triangle
                                ? line.points[k - 1].point
                                : surface.frame(to.triangle).to_plane(line.positions[k - 1]);
    const double piece = glm::distance(from, to.point);
    const glm::dvec2 direction = piece > 0.0 ? (to.point - from) / piece : glm::dvec2(1.0, 0.0);
    const bool last = k + 1 == line.points.size();
    for (; next < length + piece || (last && next <= length + piece); next += spacing) {
      const double t = piece > 0.0 ? (next - length) / piece : 0.0;
      visit(SurfacePoint{to.triangle, from + (next - length) * direction}, direction,
            line.widths[k - 1] + t * (line.widths[k] - line.widths[k - 1]));
    }
    length += piece;
  }
}

constexpr std::size_t most_samples = 50'000'000, most_seed_samples = 5'000'000;

// By slot, each once.
void merge(std::vector<LineCell>& cells) {
  std::sort(cells.begin(), cells.end(), [](const LineCell& a, const LineCell& b) { return a.slot < b.slot; });
  std::size_t kept = 0;
  for (const LineCell& cell : cells) {
    if (kept > 0 && cells[kept - 1].slot == cell.slot) {
      cells[kept - 1].generation = std::min(cells[kept - 1].generation, cell.generation);
      cells[kept - 1].width = std::max(cells[kept - 1].width, cell.width);
    } else {
      cells[kept++] = cell;
    }
  }
  cells.resize(kept);
}

}  // namespace

std::vector<LineCell> cells_of(const Surface& surface, const SurfaceDrawing& drawing) {
  const Unfolding unfolding(surface.frames(), surface.adjacency());
  const double spacing = 0.5 * surface.cell_size();
  const Bounds bounds = mesh_bounds(surface.mesh());
  const double extent = glm::distance(bounds.lower, bounds.upper);
  std::vector<LineCell> cells;
  std::size_t looked_at = 0, merge_at = std::size_t{1} << 22;
  for (const SurfaceLine& line : drawing.lines)
    sample(surface, line, spacing, [&](const SurfacePoint& at, const glm::dvec2& direction, double width) {
      const glm::dvec2 across(-direction.y, direction.x);
      const int aside = static_cast<int>(std::min(0.5 * std::clamp(width, 0.0, 4.0 * extent) / spacing, 1e8));
      looked_at += 2 * static_cast<std::size_t>(aside) + 1;
      if (looked_at > most_samples || width > 2.0 * extent)
        throw InputError("width", "the lines are so wide or long that they cover the surface many times over",
                         "draw narrower lines, or use larger cells");
      for (int k = -aside; k <= aside; ++k) {
        SurfacePoint place = at;
        if (k != 0) {
          const auto landing = unfolding.walk(at.triangle, at.point, at.point + k * spacing * across);
          if (!landing) continue;
          place = {landing->patch, landing->point};
        }
        const auto slot = cell_at(surface, place);
        if (slot) cells.push_back({*slot, line.generation, width});
      }
      if (cells.size() < merge_at) return;
      merge(cells);
      merge_at = std::max(merge_at, 2 * cells.size());
    });
  merge(cells);
  return cells;
}

Field<float> mask_of(const Surface& surface, std::span<const LineCell> cells, float value) {
  Field<float> mask(surface.slot_count(), 0.0f);
  for (const LineCell& cell : cells) mask[cell.slot] = value;
  return mask;
}

std::vector<Seed> seeds_along(const Surface& surface, const SurfaceDrawing& drawing, double spacing) {
  double widest = 0.0;
  for (const SurfaceLine& line : drawing.lines)
    for (const double width : line.widths) widest = std::max(widest, width);
  std::vector<Seed> seeds;
  std::unordered_set<std::uint32_t> taken;
  std::size_t looked_at = 0;
  for (const SurfaceLine& line : drawing.lines)
    sample(surface, line, std::max(spacing, 0.5 * surface.cell_size()),
           [&](const SurfacePoint& at, const glm::dvec2&, double width) {
             if (++looked_at > most_seed_samples)
               throw InputError(
                   "spacing", fmt::format("there are more than {} points along the lines", most_seed_samples),
                   "put them farther apart, draw shorter lines, or use larger cells");
             const auto slot = cell_at(surface, at);
             if (slot && taken.insert(*slot).second)
               seeds.push_back({*slot, widest > 0.0 ? std::max(width, 0.0) / widest : 1.0});
           });
  return seeds;
}

}  // namespace verdigris
