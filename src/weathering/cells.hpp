#pragma once
// Visits of the owned cells of a surface.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "verdigris/automaton/random.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris::weathering {

/// visit(slot), rows in parallel.
template <typename Visit>
void for_owned(const Surface& surface, Visit&& visit) {
  const auto rows = static_cast<std::uint32_t>(surface.rows().size());
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, rows, 256),
                    [&](const tbb::blocked_range<std::uint32_t>& range) {
                      for (std::uint32_t row = range.begin(); row < range.end(); ++row) {
                        const SlotRun run = surface.owned(row);
                        for (std::uint32_t slot = run.begin; slot < run.end; ++slot) visit(slot);
                      }
                    });
}

/// visit(slot), one after the other: for sums, whose bits depend on the order.
template <typename Visit>
void each_owned(const Surface& surface, Visit&& visit) {
  const auto rows = static_cast<std::uint32_t>(surface.rows().size());
  for (std::uint32_t row = 0; row < rows; ++row) {
    const SlotRun run = surface.owned(row);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot) visit(slot);
  }
}

/// The slots around an owned one, ghosts among them: counter-clockwise from the right, sides at even places.
inline std::array<std::uint32_t, 8> around(const Surface& surface, std::uint32_t slot) {
  const Row* here = surface.rows().data() + surface.row_of(slot);
  const std::uint32_t column = slot - here->base;
  const std::uint32_t above = here[1].base + column, below = here[-1].base + column;
  return {slot + 1, above + 1, above, above - 1, slot - 1, below - 1, below, below + 1};
}

/// A random number of [0, 1).
inline double uniform(std::uint64_t seed, std::uint64_t step, std::uint32_t cell, std::uint32_t purpose) {
  return CellRandom(seed, step, cell).words(purpose)[0] / 4294967296.0;
}

}  // namespace verdigris::weathering
