#pragma once
// Visits of the owned cells of a surface.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cstdint>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// visit(slot) for every owned cell, rows in parallel.
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

/// visit(slot) for every owned cell, one after the other: for sums, whose bits depend on the order.
template <typename Visit>
void each_owned(const Surface& surface, Visit&& visit) {
  const auto rows = static_cast<std::uint32_t>(surface.rows().size());
  for (std::uint32_t row = 0; row < rows; ++row) {
    const SlotRun run = surface.owned(row);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot) visit(slot);
  }
}

}  // namespace verdigris
