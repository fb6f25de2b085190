#pragma once
// Cells of a surface, those around them, and their random numbers.

#include <array>
#include <cstdint>

#include "verdigris/automaton/random.hpp"
#include "verdigris/surface/owned_cells.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris::weathering {

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
