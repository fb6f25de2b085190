#include "verdigris/surface/surface.hpp"

#include <algorithm>

namespace verdigris {

std::size_t Surface::bytes() const {
  return frames_.size() * sizeof(Frame) + row_begin_.size() * sizeof(std::uint32_t) +
         rows_.size() * sizeof(Row) + comp_in_.size() * sizeof(SlotRun) +
         row_hint_.size() * sizeof(std::uint32_t) + links_.bytes();
}

std::uint32_t Surface::patch_of_row(std::uint32_t row) const {
  // Patches without rows share their begin with the next one; the last of equals is the one that has the row.
  return static_cast<std::uint32_t>(std::upper_bound(row_begin_.begin(), row_begin_.end(), row) -
                                    row_begin_.begin() - 1);
}

CellRef Surface::cell(std::uint32_t slot) const {
  const std::uint32_t row = row_of(slot);
  const std::uint32_t patch = patch_of_row(row);
  return {patch, grid_row(patch, row), static_cast<std::int32_t>(slot - rows()[row].base)};
}

bool Surface::is_owned(std::uint32_t slot) const {
  const SlotRun run = owned(row_of(slot));
  return run.begin <= slot && slot < run.end;
}

glm::dvec3 Surface::position(std::uint32_t slot) const {
  const CellRef c = cell(slot);
  return frames_[c.patch].to_model(centre(c.row, c.column));
}

}  // namespace verdigris
