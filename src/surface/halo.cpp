#include "verdigris/surface/halo.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

#include "patch_ghosts.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

constexpr std::size_t patches_a_task = 64;
constexpr double most_around = 100.0;  // halo cells for each cell: minutes at a million cells

struct Finder {
  const Surface& surface;
  PatchRows rows;
  Unfolding unfolding;
  std::int32_t reach;

  // Owned columns of a grid row; none outside the patch.
  Columns run(std::uint32_t patch, std::int32_t row) const {
    const std::uint32_t first = surface.row_begin(patch), last = surface.row_end(patch);
    if (row < -1 || row + 1 >= static_cast<std::int32_t>(last - first)) return {0, 0};
    return columns_of(rows.rows[first + static_cast<std::uint32_t>(row + 1)]);
  }

  Halo::Patch raster(std::uint32_t patch) const {
    const std::uint32_t first = surface.row_begin(patch), last = surface.row_end(patch);
    if (first == last) return {0, 0, 0, 0};
    std::int32_t left = 0x7FFFFFFF, right = -0x7FFFFFFF;
    const auto count = static_cast<std::int32_t>(last - first) - 2;
    for (std::int32_t row = 0; row < count; ++row) {
      const Columns c = run(patch, row);
      if (c.begin >= c.end) continue;
      left = std::min(left, c.begin);
      right = std::max(right, c.end);
    }
    return {0, left - reach, static_cast<std::uint32_t>(right - left + 2 * reach),
            static_cast<std::uint32_t>(count + 2 * reach)};
  }

  void find(std::uint32_t patch, const Halo::Patch& raster, std::vector<HaloCell>& found) const {
    const PatchGhosts ghosts(rows, unfolding, patch);
    Joints joints;
    std::vector<Columns> runs;  // [raster row]
    for (std::uint32_t y = 0; y < raster.height; ++y)
      runs.push_back(run(patch, static_cast<std::int32_t>(y) - reach));
    struct Start {
      std::int32_t distance2, row, column;
    };
    std::vector<Start> starts;
    const auto height = static_cast<std::int32_t>(raster.height);
    for (std::int32_t y = 0; y < height; ++y)
      for (std::int32_t x = 0; x < static_cast<std::int32_t>(raster.width); ++x) {
        const std::int32_t column = raster.left + x;
        if (within(runs[static_cast<std::size_t>(y)], column, 0)) {
          x = runs[static_cast<std::size_t>(y)].end - 1 - raster.left;
          continue;
        }
        // The nearest owned cell of each row in reach: those that see it.
        starts.clear();
        for (std::int32_t near = std::max(0, y - reach); near <= std::min(height - 1, y + reach); ++near) {
          const Columns& c = runs[static_cast<std::size_t>(near)];
          if (!within(c, column, reach)) continue;
          const std::int32_t from = std::clamp(column, c.begin, c.end - 1), dx = from - column, dy = near - y;
          starts.push_back({dx * dx + dy * dy, near - reach, from});
        }
        if (starts.empty()) continue;
        const auto nearest_first = [&](auto&& walk) {
          const bool seen = each_neighbour([&](std::int32_t dx, std::int32_t dy) {
            return y + dy >= 0 && y + dy < height &&
                   within(runs[static_cast<std::size_t>(y + dy)], column + dx, 0) &&
                   walk(y + dy - reach, column + dx);
          });
          if (seen) return;
          std::stable_sort(starts.begin(), starts.end(),
                           [](const Start& a, const Start& b) { return a.distance2 < b.distance2; });
          for (const Start& start : starts)
            if (walk(start.row, start.column)) return;
        };
        if (const auto source = ghosts.source(y - reach, column, nearest_first, joints))
          found.push_back(
              {static_cast<std::uint32_t>(y) * raster.width + static_cast<std::uint32_t>(x), *source});
      }
  }
};

}  // namespace

Halo::Halo(const Surface& surface, unsigned reach) : surface_(surface), reach_(reach) {
  if (surface.link_kind() != LinkKind::unfolded || reach == 0)
    throw std::invalid_argument("a halo needs unfolded links and a reach of at least 1");
  const Finder finder{surface,
                      // rows()[k + 1] of the last row is the empty one after it
                      {{surface.rows().data(), surface.rows().size() + 1},
                       surface.row_begins(),
                       surface.owned_runs(),
                       surface.cell_size()},
                      Unfolding(surface.frames(), surface.adjacency(), surface.barred_edges()),
                      static_cast<std::int32_t>(reach)};
  const std::size_t count = surface.patch_count(), tasks = (count + patches_a_task - 1) / patches_a_task;
  patches_.resize(count + 1);
  // Around triangles much smaller than the reach there is far more halo than surface.
  double around = 0.0;
  for (std::uint32_t p = 0; p < count; ++p) {
    const Patch raster = finder.raster(p);
    around += static_cast<double>(raster.width) * raster.height;
  }
  const double cells = static_cast<double>(surface.owned_count());
  if (around > most_around * cells || around * sizeof(HaloCell) > 8e9)
    throw InputError(
        "range",
        fmt::format("{} cells reach over so many triangles that {:.0f} cells would be kept for each one",
                    reach, around / cells),
        "use a smaller range, smaller cells (--cells), or a model of larger triangles");
  std::vector<std::vector<HaloCell>> found(tasks);
  tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
    for (std::size_t p = task * patches_a_task; p < std::min(count, (task + 1) * patches_a_task); ++p) {
      patches_[p] = finder.raster(static_cast<std::uint32_t>(p));
      patches_[p].begin = found[task].size();
      finder.find(static_cast<std::uint32_t>(p), patches_[p], found[task]);
    }
  });
  std::size_t total = 0;
  for (const auto& list : found) total += list.size();
  cells_.reserve(total);
  for (std::size_t task = 0; task < tasks; ++task) {
    for (std::size_t p = task * patches_a_task; p < std::min(count, (task + 1) * patches_a_task); ++p) {
      patches_[p].begin += cells_.size();
    }
    cells_.insert(cells_.end(), found[task].begin(), found[task].end());
    found[task] = {};
  }
  patches_[count] = {cells_.size(), 0, 0, 0};
}

}  // namespace verdigris
