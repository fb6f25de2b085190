// Edge-pair links (Gobron & Chiba 1999, "Edge Communication", Fig. 7).

#include <algorithm>
#include <cmath>

#include "joints.hpp"

namespace verdigris {

namespace {

// A cell that an edge crosses, and where its centre projects on the edge: 0 at the edge's first corner.
struct Crossed {
  double at;
  std::uint32_t slot;
};

// The active cells of `patch` that edge k crosses, in order along it. `reversed` measures from the other end.
std::vector<Crossed> crossed_cells(const PatchRows& rows, const Frame& frame, std::uint32_t patch, int k,
                                   bool reversed) {
  std::vector<Crossed> cells;
  const std::uint32_t first = rows.row_begin[patch], last = rows.row_begin[patch + 1];
  if (first == last) return cells;
  const double h = rows.cell_size;
  const glm::dvec2 p = frame.corner(k), q = frame.corner((k + 1) % 3), d = q - p;
  const double length = std::sqrt(d.x * d.x + d.y * d.y);
  const double low = std::min(p.y, q.y) / h, high = std::max(p.y, q.y) / h;
  constexpr double touch = 1e-3;  // cells; a corner that the edge only touches does not count
  for (auto row = static_cast<std::int64_t>(std::floor(low + touch)); static_cast<double>(row) <= high;
       ++row) {
    const std::int64_t index = first + 1 + row;
    if (row < 0 || index >= last) continue;
    const Row& r = rows.rows[static_cast<std::size_t>(index)];
    // The part of the edge within the row.
    double x0 = p.x / h, x1 = q.x / h;
    if (high - low > 0.0) {
      const double y0 = std::clamp(static_cast<double>(row), low, high),
                   y1 = std::clamp(static_cast<double>(row + 1), low, high);
      const double slope = d.x / d.y;
      x0 = p.x / h + slope * (y0 - p.y / h);
      x1 = p.x / h + slope * (y1 - p.y / h);
    }
    if (x0 > x1) std::swap(x0, x1);
    const auto run_begin = static_cast<std::int32_t>(r.run_begin - r.base),
               run_end = static_cast<std::int32_t>(r.run_end - r.base);
    const auto begin = std::max(run_begin, static_cast<std::int32_t>(std::floor(x0 + touch)));
    const auto end = std::min(run_end, std::max(static_cast<std::int32_t>(std::ceil(x1 - touch)), begin + 1));
    for (std::int32_t column = begin; column < end; ++column) {
      const glm::dvec2 c = glm::dvec2((column + 0.5) * h, (static_cast<double>(row) + 0.5) * h) - p;
      const double along = std::clamp((c.x * d.x + c.y * d.y) / length, 0.0, length);
      cells.push_back({reversed ? length - along : along, r.base + static_cast<std::uint32_t>(column)});
    }
  }
  std::sort(cells.begin(), cells.end(), [](const Crossed& a, const Crossed& b) {
    return a.at < b.at || (a.at == b.at && a.slot < b.slot);
  });
  return cells;
}

void pair_each(const std::vector<Crossed>& from, const std::vector<Crossed>& to, Joints& joints) {
  for (const Crossed& cell : from) {
    auto after = std::lower_bound(to.begin(), to.end(), cell.at,
                                  [](const Crossed& c, double at) { return c.at < at; });
    if (after == to.end() || (after != to.begin() && cell.at - std::prev(after)->at <= after->at - cell.at))
      --after;
    joints.pairs.push_back(std::uint64_t{cell.slot} << 32 | after->slot);
    joints.pairs.push_back(std::uint64_t{after->slot} << 32 | cell.slot);
  }
}

}  // namespace

void find_edge_pairs(const PatchRows& rows, const Unfolding& unfolding, std::uint32_t patch, Joints& joints) {
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t across = unfolding.across(patch, k);
    if (across == Adjacency::none || across < unfolding.half_edge(patch, k)) continue;
    const std::uint32_t other = across / 3;
    const auto here = crossed_cells(rows, unfolding.frame(patch), patch, k, false);
    const auto there = crossed_cells(rows, unfolding.frame(other), other, unfolding.frame_edge(across), true);
    if (here.empty() || there.empty()) continue;
    pair_each(here, there, joints);
    pair_each(there, here, joints);
  }
}

}  // namespace verdigris
