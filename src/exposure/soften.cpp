#include "verdigris/exposure/soften.hpp"

#include <cmath>
#include <limits>

#include "at_cells.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

void soften(const Surface& surface, Field<float>& field, int passes) {
  // Slots that hold nothing are not numbers, and left out.
  Field<float> known(field.size(), std::numeric_limits<float>::quiet_NaN());
  each_cell(surface, [&](std::size_t, std::uint32_t slot, glm::dvec2) { known[slot] = field[slot]; });
  for (int pass = 0; pass < passes; ++pass) {
    if (pass > 0)
      each_cell(surface, [&](std::size_t, std::uint32_t slot, glm::dvec2) { known[slot] = field[slot]; });
    copy_to_ghosts(surface, known);
    tbb::parallel_for(std::size_t{0}, surface.patch_count(), [&](std::size_t patch) {
      for (std::uint32_t r = surface.row_begin(patch); r < surface.row_end(patch); ++r) {
        const Row& row = surface.rows()[r];
        for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
          float sum = 0.0f, weight = 0.0f;
          // A row that evolves has rows below and above it.
          for (int dy = -1; dy <= 1; ++dy) {
            const std::uint32_t base = surface.rows()[r + static_cast<std::uint32_t>(dy)].base;
            for (int dx = -1; dx <= 1; ++dx) {
              const float v = known[slot - row.base + base + static_cast<std::uint32_t>(dx)];
              if (std::isnan(v)) continue;
              const float w = (dx == 0 ? 2.0f : 1.0f) * (dy == 0 ? 2.0f : 1.0f);
              sum += w * v;
              weight += w;
            }
          }
          field[slot] = sum / weight;
        }
      }
    });
  }
  copy_to_ghosts(surface, field);
}

}  // namespace verdigris
