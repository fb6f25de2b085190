#include "corrosion_start.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris::corrosion {

namespace {

using Word = CorrosionRule::State;
constexpr std::uint32_t strong_purpose = 0x434f5204;

// visit(row, slot) for every evolving cell, rows in parallel.
template <typename Visit>
void for_cells(const Surface& surface, Visit&& visit) {
  const auto rows = surface.rows();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows.size(), 256),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t r = range.begin(); r < range.end(); ++r)
                        for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
                          visit(rows.data()[r], slot);
                    });
}

const Field<float>* checked_mask(const SimulationSetup& setup, const char* name) {
  const Field<float>* mask = setup.mask(name);
  if (mask != nullptr && mask->size() != setup.surface.slot_count())
    throw InputError(fmt::format("mask {}", name),
                     fmt::format("it has {} numbers, not one for each of {} slots", mask->size(),
                                 setup.surface.slot_count()),
                     "make it for this surface");
  return mask;
}

// The least value among the highest `share` of the cells.
float least_of_highest(const Surface& surface, const Field<float>& values, double share) {
  std::vector<float> all;
  for (const Row& row : surface.rows())
    all.insert(all.end(), values.begin() + row.run_begin, values.begin() + row.run_end);
  const auto count = static_cast<std::size_t>(std::llround(share * static_cast<double>(all.size())));
  if (count == 0) return std::numeric_limits<float>::infinity();
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(count - 1);
  std::nth_element(all.begin(), at, all.end(), std::greater<>());
  return *at;
}

}  // namespace

void check(const SimulationSetup& setup, const CorrosionParameters& parameters) {
  if (setup.surface.link_kind() != LinkKind::unfolded)
    throw InputError("links", "corrosion attacks in directions, which projected pairs do not carry",
                     "use unfolded links");
  if (setup.seeds.empty() && (parameters.new_seeds <= 0.0 || parameters.most_seeds == 0))
    throw InputError("seeds", "there are none, and none will come",
                     "give seeds, or new_seeds and most_seeds above 0");
  std::vector<std::uint32_t> slots;
  for (const Seed& seed : setup.seeds) {
    slots.push_back(seed.slot);
    if (!setup.barrier.empty() && setup.barrier[seed.slot] != 0)
      throw InputError("seeds", fmt::format("seed {} lies on a barrier", slots.size() - 1),
                       "move the seed, or the barrier");
  }
  std::sort(slots.begin(), slots.end());
  if (std::adjacent_find(slots.begin(), slots.end()) != slots.end())
    throw InputError("seeds", "two lie in one cell", "move one of them, or use smaller cells");
}

Field<std::uint8_t> levels_of(const SimulationSetup& setup, const char* name) {
  const Field<float>* mask = checked_mask(setup, name);
  if (mask == nullptr) return {};
  Field<std::uint8_t> levels(mask->size(), 0);
  for_cells(setup.surface, [&](const Row&, std::uint32_t slot) {
    const float value = (*mask)[slot];
    levels[slot] =
        static_cast<std::uint8_t>(std::lround(255.0f * (value >= 0.0f ? std::min(value, 1.0f) : 0.0f)));
  });
  copy_to_ghosts(setup.surface, levels);
  return levels;
}

Field<Word> first_state(const SimulationSetup& setup, const CorrosionParameters& parameters,
                        const CorrosionRule& rule) {
  const Surface& surface = setup.surface;
  const Field<float>* mask = checked_mask(setup, "strong");
  const bool ranked = mask != nullptr && parameters.strong_by == "highest";
  const float least = ranked ? least_of_highest(surface, *mask, parameters.strong) : 0.0f;
  Field<Word> state = large_vector(surface.slot_count(), Word{rule.outside()});
  for_cells(surface, [&](const Row&, std::uint32_t slot) {
    if (!setup.barrier.empty() && setup.barrier[slot] != 0) return;
    const double chance = mask != nullptr ? double{(*mask)[slot]} : parameters.strong;
    const bool strong = ranked ? (*mask)[slot] >= least
                               : CellRandom(setup.seed, 0, slot).words(strong_purpose)[0] < threshold(chance);
    state[slot] = CorrosionRule::sound_word(strong);
  });
  for (const Seed& seed : setup.seeds) state[seed.slot] = CorrosionRule::corroded_word(0, state[seed.slot]);
  copy_to_ghosts(surface, state);
  std::vector<std::uint8_t> holds(surface.slot_count(), 0);
  for_cells(surface, [&](const Row& row, std::uint32_t slot) {
    if (!CorrosionRule::sound(state[slot])) return;
    const Row *below = &row - 1, *above = &row + 1;
    const std::uint32_t column = slot - row.base;
    const Neighbourhood<Word> n{state.data() + static_cast<std::uint32_t>(below->base + column),
                                state.data() + slot,
                                state.data() + static_cast<std::uint32_t>(above->base + column)};
    holds[slot] = rule.held(state[slot], CorrosionRule::around(n), slot) != state[slot];
  });
  for_cells(surface, [&](const Row&, std::uint32_t slot) {
    if (holds[slot] != 0) state[slot] |= CorrosionRule::done_bit;
  });
  return state;
}

}  // namespace verdigris::corrosion
