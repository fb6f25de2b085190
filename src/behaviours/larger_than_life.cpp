#include "verdigris/behaviours/larger_than_life.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "verdigris/base/large_memory.hpp"

namespace verdigris {

// A patch with its halo, as sums of live cells from the left end of each row on: the count between two
// columns is a difference. 16 bits are enough for any, since they wrap around alike.
struct LargerThanLife::Room {
  std::vector<std::uint8_t> cells;
  std::vector<std::uint16_t> sums, counts;
};

struct LargerThanLife::Rooms {
  tbb::enumerable_thread_specific<Room> of_thread;
};

LargerThanLife::LargerThanLife(const Halo& halo, RangeRule rule, Field<std::uint8_t> alive,
                               std::uint64_t steps)
    : halo_(&halo),
      rule_(std::move(rule)),
      state_(std::move(alive)),
      next_(large_copy(state_)),
      steps_(steps),
      rooms_(std::make_shared<Rooms>()) {
  if (halo.reach() != rule_.range) throw std::invalid_argument("the halo is of another range than the rule");
}

std::uint64_t LargerThanLife::advance(std::size_t patch, Room& room) {
  const Surface& surface = halo_->surface();
  const Halo::Patch& raster = halo_->patch(patch);
  if (raster.height == 0) return 0;
  const std::size_t width = raster.width, height = raster.height, stride = width + 1;
  const auto reach = static_cast<std::size_t>(rule_.range);
  // Raster row `reach` is grid row 0, the second row of the patch.
  const Row* rows = surface.rows().data() + surface.row_begin(patch) + 1;
  const auto column_of = [&](const Row& row, std::uint32_t slot) {
    return static_cast<std::size_t>(static_cast<std::int32_t>(slot - row.base) - raster.left);
  };
  room.cells.assign(width * height, 0);
  for (std::size_t y = reach; y + reach < height; ++y) {
    const Row& row = rows[y - reach];
    if (row.run_begin == row.run_end) continue;
    std::copy(state_.begin() + row.run_begin, state_.begin() + row.run_end,
              room.cells.begin() + static_cast<std::ptrdiff_t>(y * width + column_of(row, row.run_begin)));
  }
  for (const HaloCell& cell : halo_->cells(patch)) room.cells[cell.offset] = state_[cell.source];
  room.sums.resize(stride * height);
  for (std::size_t y = 0; y < height; ++y) {
    std::uint16_t sum = 0, *sums = room.sums.data() + y * stride;
    sums[0] = 0;
    for (std::size_t x = 0; x < width; ++x)
      sums[x + 1] = sum = static_cast<std::uint16_t>(sum + room.cells[y * width + x]);
  }

  std::uint64_t changed = 0;
  for (std::size_t y = reach; y + reach < height; ++y) {
    const Row& row = rows[y - reach];
    const std::size_t count = row.run_end - row.run_begin;
    if (count == 0) continue;
    const std::size_t from = column_of(row, row.run_begin);
    room.counts.assign(count, 0);
    std::uint16_t* counts = room.counts.data();
    const auto r = static_cast<int>(rule_.range);
    for (int dy = -r; dy <= r; ++dy) {
      const auto half = static_cast<std::size_t>(rule_.half_width(dy));
      const std::uint16_t* sums =
          room.sums.data() + (y + static_cast<std::size_t>(r + dy) - reach) * stride + from;
      const std::uint16_t *right = sums + half + 1, *left = sums - half;
      for (std::size_t k = 0; k < count; ++k)
        counts[k] = static_cast<std::uint16_t>(counts[k] + right[k] - left[k]);
    }
    const std::uint8_t* old = state_.data() + row.run_begin;
    std::uint8_t* next = next_.data() + row.run_begin;
    for (std::size_t k = 0; k < count; ++k) {
      const unsigned live = counts[k] - (rule_.middle ? 0u : old[k]);
      next[k] = old[k] != 0 ? rule_.survival[live] : rule_.birth[live];
      changed += next[k] != old[k];
    }
  }
  return changed;
}

std::uint64_t LargerThanLife::step() {
  const std::size_t patches = halo_->surface().patch_count();
  // Some 20,000 cells a task.
  const std::size_t grain = std::clamp<std::size_t>(20000 * patches / (state_.size() + 1), 1, 16);
  const std::uint64_t changed = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, patches, grain), std::uint64_t{0},
      [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t sum) {
        Room& room = rooms_->of_thread.local();
        for (std::size_t patch = range.begin(); patch < range.end(); ++patch) sum += advance(patch, room);
        return sum;
      },
      std::plus<>());
  state_.swap(next_);
  ++steps_;
  return changed;
}

}  // namespace verdigris
