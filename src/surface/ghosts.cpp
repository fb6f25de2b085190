// Ghost links by unfolding: a cell beyond an edge copies the owned cell nearest to where it comes to lie when
// the neighbouring triangle is turned about the shared edge into the plane.

#include "patch_ghosts.hpp"

namespace verdigris {

void find_ghosts(const PatchRows& rows, const Unfolding& unfolding, std::uint32_t patch, Joints& joints) {
  const std::uint32_t first = rows.row_begin[patch], last = rows.row_begin[patch + 1];
  if (first == last) return;
  const PatchGhosts ghosts(rows, unfolding, patch);
  for (std::uint32_t index = first; index < last; ++index) {
    const Row& row = rows.rows[index];
    const std::int32_t grid_row = static_cast<std::int32_t>(index - first) - 1;
    const Columns near[3] = {index > first ? columns_of(rows.rows[index - 1]) : Columns{0, 0},
                             columns_of(row),
                             index + 1 < last ? columns_of(rows.rows[index + 1]) : Columns{0, 0}};
    const auto begin = static_cast<std::int32_t>(row.begin - row.base);
    const auto end = begin + static_cast<std::int32_t>(rows.rows[index + 1].begin - row.begin);
    for (std::int32_t column = begin; column < end; ++column) {
      if (within(near[1], column, 0)) {
        column = near[1].end - 1;
        continue;
      }
      if (!within(near[0], column, 1) && !within(near[1], column, 1) && !within(near[2], column, 1)) continue;
      const auto from_neighbours = [&](auto&& walk) {
        each_neighbour([&](std::int32_t dx, std::int32_t dy) {
          return within(near[dy + 1], column + dx, 0) && walk(grid_row + dy, column + dx);
        });
      };
      if (const auto source = ghosts.source(grid_row, column, from_neighbours, joints))
        joints.pairs.push_back(std::uint64_t{*source} << 32 |
                               (row.base + static_cast<std::uint32_t>(column)));
    }
  }
}

}  // namespace verdigris
