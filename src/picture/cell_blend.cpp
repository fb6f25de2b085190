#include "verdigris/picture/cell_blend.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/surface/walk.hpp"

namespace verdigris {

CellBlends::CellBlends(const Surface& surface) : surface_(surface), known_(surface.slot_count() / 64 + 1, 0) {
  const auto mark = [&](std::uint32_t slot) { known_[slot >> 6] |= std::uint64_t{1} << (slot & 63); };
  for (const Row& row : surface.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) mark(slot);
  surface.links().for_each([&](std::uint32_t, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) mark(target);
  });
}

CellBlend CellBlends::at(std::uint32_t patch, glm::dvec2 point) const {
  constexpr double least_weight = 1e-4;  // as near to a grid line as centres are dropped beside the contour
  CellBlend blend;
  const std::uint32_t row_begin = surface_.row_begin(patch), row_end = surface_.row_end(patch);
  if (row_begin == row_end) return blend;
  const double x = point.x / surface_.cell_size() - 0.5, y = point.y / surface_.cell_size() - 0.5;
  const double i = std::floor(x), j = std::floor(y);
  const double fx = x - i, fy = y - j;
  double sum = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int di = corner & 1, dj = corner >> 1;
    const double weight = (di ? fx : 1.0 - fx) * (dj ? fy : 1.0 - fy);
    const std::int64_t row = static_cast<std::int64_t>(j) + dj + 1 + row_begin;  // grid row -1 comes first
    if (weight < least_weight || row < row_begin || row >= row_end) continue;
    const auto r = static_cast<std::size_t>(row);
    const std::int64_t end = r + 1 < surface_.rows().size()
                                 ? std::int64_t{surface_.rows()[r + 1].begin}
                                 : static_cast<std::int64_t>(surface_.slot_count());
    const Row& cells = surface_.rows()[r];
    // Column 0 is slot `base` modulo 2^32; the true slot is found from the first slot's column, without
    // wrapping.
    const std::int64_t first_column = static_cast<std::int32_t>(cells.begin - cells.base);
    const std::int64_t slot = cells.begin + (static_cast<std::int64_t>(i) + di - first_column);
    if (slot < cells.begin || slot >= end || !has_value(static_cast<std::uint32_t>(slot))) continue;
    blend.cells[blend.count++] = {static_cast<std::uint32_t>(slot), static_cast<float>(weight)};
    sum += weight;
  }
  for (std::uint8_t k = 0; k < blend.count; ++k)
    blend.cells[k].weight = static_cast<float>(blend.cells[k].weight / sum);
  return blend;
}

GhostBlends::GhostBlends(const CellBlends& blends) : surface_(blends.surface()) {
  const Unfolding unfolding(surface_.frames(), surface_.adjacency(), surface_.barred_edges());
  tbb::enumerable_thread_specific<std::vector<Ghost>> found;
  const auto gap = [&](const CellBlend& blend, const Landing& landing) {
    glm::dvec3 gap = surface_.frame(landing.patch).to_model(landing.point);
    for (std::uint8_t k = 0; k < blend.count; ++k)
      gap -= double{blend.cells[k].weight} * surface_.position(blend.cells[k].slot);
    return glm::length(gap) < 1e-3 * surface_.cell_size() ? glm::vec3(0.0f) : glm::vec3(gap);
  };
  const auto rows = surface_.rows();
  const auto visit_row = [&](std::uint32_t row, std::vector<Ghost>& list) {
    const std::uint32_t patch = surface_.patch_of_row(row);
    if (row < surface_.row_begin(patch) || row >= surface_.row_end(patch)) return;
    const std::uint32_t end =
        row + 1 < rows.size() ? rows[row + 1].begin : static_cast<std::uint32_t>(surface_.slot_count());
    const std::int32_t grid_row = surface_.grid_row(patch, row);
    for (std::uint32_t slot = rows[row].begin; slot < end; ++slot) {
      if (slot == rows[row].run_begin) slot = rows[row].run_end;
      if (slot >= end || !blends.has_value(slot)) continue;
      const auto column = static_cast<std::int32_t>(slot - rows[row].base);
      // From a cell of its own patch beside it, straight over the edges between them: sides first.
      constexpr std::array<std::array<std::int32_t, 2>, 8> beside{
          {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
      for (const auto& [dx, dy] : beside) {
        const std::int64_t near_row = std::int64_t{row} + dy;
        if (near_row < surface_.row_begin(patch) || near_row >= surface_.row_end(patch)) continue;
        const SlotRun run = surface_.owned(static_cast<std::uint32_t>(near_row));
        const std::uint32_t base = rows[static_cast<std::size_t>(near_row)].base;
        if (run.begin == run.end || column + dx < static_cast<std::int32_t>(run.begin - base) ||
            column + dx >= static_cast<std::int32_t>(run.end - base))
          continue;
        const auto landing = unfolding.walk(patch, surface_.centre(grid_row + dy, column + dx),
                                            surface_.centre(grid_row, column), 64);
        if (!landing) continue;
        if (const CellBlend blend = blends.at(landing->patch, landing->point); blend.count > 0)
          list.push_back({slot, blend, gap(blend, *landing)});
        break;
      }
    }
  };
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(rows.size()), 256),
                    [&](const tbb::blocked_range<std::uint32_t>& range) {
                      for (std::uint32_t row = range.begin(); row < range.end(); ++row)
                        visit_row(row, found.local());
                    });
  for (const auto& list : found) ghosts_.insert(ghosts_.end(), list.begin(), list.end());
  std::sort(ghosts_.begin(), ghosts_.end(), [](const Ghost& a, const Ghost& b) { return a.slot < b.slot; });
}

void GhostBlends::fill(std::span<float> values, std::span<const glm::vec3> slopes) const {
  if (slopes.empty()) copy_to_ghosts(surface_, values);
  // A blend may have ghosts of its own patch in it: their error shrinks with each round.
  std::vector<float> next(ghosts_.size());
  for (int round = 0; round < 6; ++round) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ghosts_.size(), 4096),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t k = range.begin(); k < range.end(); ++k) {
                          float sum = 0.0f;
                          for (std::uint8_t n = 0; n < ghosts_[k].blend.count; ++n) {
                            const BlendSource& from = ghosts_[k].blend.cells[n];
                            sum += from.weight * values[from.slot];
                          }
                          if (!slopes.empty() && ghosts_[k].gap != glm::vec3(0.0f))
                            for (std::uint8_t n = 0; n < ghosts_[k].blend.count; ++n) {
                              const BlendSource& from = ghosts_[k].blend.cells[n];
                              sum += from.weight * glm::dot(slopes[from.slot], ghosts_[k].gap);
                            }
                          next[k] = sum;
                        }
                      });
    for (std::size_t k = 0; k < ghosts_.size(); ++k) values[ghosts_[k].slot] = next[k];
  }
}

}  // namespace verdigris
