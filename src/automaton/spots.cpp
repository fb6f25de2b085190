#include "verdigris/automaton/spots.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <numbers>

#include "../mesh/disjoint_sets.hpp"

namespace verdigris {

namespace {

// visit(neighbour slot, it is a corner) for the eight neighbours of a slot in a row.
template <typename Visit>
void for_neighbours(const Row& row, std::uint32_t slot, Visit&& visit) {
  const std::uint32_t column = slot - row.base;
  for (int d = -1; d <= 1; ++d) {
    const Row& r = (&row)[d];
    for (std::uint32_t k = 0; k < 3; ++k)
      if (d != 0 || k != 1) visit(r, r.base + column + k - 1, d != 0 && k != 1);
  }
}

bool evolves(const Row& row, std::uint32_t slot) {
  return slot - row.run_begin < row.run_end - row.run_begin;
}

}  // namespace

Spots measure_spots(const Surface& surface, const Field<SpotCell>& cells) {
  const auto rows = surface.rows();
  DisjointSets sets(surface.slot_count());
  std::uint64_t sides = 0, corners = 0;
  for (std::uint32_t r = 0; r < rows.size(); ++r) {
    const Row& row = rows.data()[r];
    const SlotRun run = surface.owned(r);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot) {
      if (cells[slot] != SpotCell::in) continue;
      for_neighbours(row, slot, [&](const Row& its_row, std::uint32_t near, bool corner) {
        (corner ? corners : sides) += cells[near] == SpotCell::out;
        if (cells[near] == SpotCell::in && near < slot && evolves(its_row, near)) sets.join(slot, near);
      });
    }
  }
  // Across edges: what lies around a ghost touches its owner.
  surface.links().for_each([&](std::uint32_t source, auto ghosts) {
    if (cells[source] != SpotCell::in) return;
    for (const std::uint32_t ghost : ghosts)
      for_neighbours(rows.data()[surface.row_of(ghost)], ghost,
                     [&](const Row& its_row, std::uint32_t near, bool) {
                       if (evolves(its_row, near) && cells[near] == SpotCell::in) sets.join(source, near);
                     });
  });

  Spots spots;
  std::vector<std::uint32_t> count(surface.slot_count(), 0);
  for (std::uint32_t r = 0; r < rows.size(); ++r)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot)
      if (cells[slot] == SpotCell::in) ++count[sets.find(slot)];
  for (const std::uint32_t size : count)
    if (size > 0) spots.sizes.push_back(size);
  std::sort(spots.sizes.begin(), spots.sizes.end(), std::greater<>());
  spots.perimeter = std::numbers::pi / 8.0 * surface.cell_size() *
                    (static_cast<double>(sides) + std::sqrt(0.5) * static_cast<double>(corners));
  return spots;
}

std::vector<std::uint64_t> spot_histogram(const Spots& spots) {
  std::vector<std::uint64_t> bins;
  for (const std::uint64_t size : spots.sizes) {
    const auto bin = static_cast<std::size_t>(std::bit_width(size)) - 1;
    if (bin >= bins.size()) bins.resize(bin + 1, 0);
    ++bins[bin];
  }
  return bins;
}

}  // namespace verdigris
