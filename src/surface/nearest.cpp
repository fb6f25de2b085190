#include "nearest.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace verdigris {

namespace {

// Squared distance from p to the segment of edge k.
double squared_distance_to_edge(const Frame& frame, int k, glm::dvec2 p) {
  const glm::dvec2 a = frame.corner(k), b = frame.corner((k + 1) % 3);
  const glm::dvec2 d = b - a, e = p - a;
  const double length2 = d.x * d.x + d.y * d.y;
  const double t = length2 > 0.0 ? std::clamp((e.x * d.x + e.y * d.y) / length2, 0.0, 1.0) : 0.0;
  const glm::dvec2 r = e - t * d;
  return r.x * r.x + r.y * r.y;
}

struct Best {
  double distance2;  // in cells squared
  std::uint32_t slot = 0;
  bool found = false;

  void take(double candidate2, std::uint32_t candidate) {
    if (candidate2 < distance2 || (candidate2 == distance2 && found && candidate < slot)) {
      distance2 = candidate2;
      slot = candidate;
      found = true;
    }
  }
};

// The nearest owned centre of one patch: in each row near the point, the run clamped to the point's column.
void search_patch(const PatchRows& rows, std::uint32_t patch, glm::dvec2 point, Best& best) {
  const std::uint32_t first = rows.row_begin[patch], last = rows.row_begin[patch + 1];
  if (first == last) return;
  const double x = point.x / rows.cell_size - 0.5, y = point.y / rows.cell_size - 0.5;
  const double reach = std::sqrt(best.distance2);
  const double top = static_cast<double>(last - first) - 2.0;
  const auto low = static_cast<std::int64_t>(std::clamp(std::ceil(y - reach), -1.0, top));
  const auto high = static_cast<std::int64_t>(std::clamp(std::floor(y + reach), -1.0, top));
  for (std::int64_t row = low; row <= high; ++row) {
    const auto index = static_cast<std::uint32_t>(first + 1 + row);
    const SlotRun run = rows.owned(index);
    if (run.begin == run.end) continue;
    const std::uint32_t base = rows.rows[index].base;
    const auto begin = static_cast<std::int32_t>(run.begin - base),
               end = static_cast<std::int32_t>(run.end - base);
    const double column = std::clamp(std::floor(x + 0.5), static_cast<double>(begin), end - 1.0);
    const double dx = column - x, dy = static_cast<double>(row) - y;
    best.take(dx * dx + dy * dy, base + static_cast<std::uint32_t>(static_cast<std::int32_t>(column)));
  }
}

}  // namespace

std::optional<NearestCell> nearest_cell(const PatchRows& rows, const Unfolding& unfolding,
                                        std::uint32_t patch, glm::dvec2 point, std::uint32_t except,
                                        double reach, std::size_t most_patches) {
  Best best{reach * reach};
  if (patch != except) search_patch(rows, patch, point, best);
  // The cell around the point is owned: nothing better is asked for.
  if (best.found && best.distance2 <= 0.5) return NearestCell{best.slot, std::sqrt(best.distance2)};

  struct Visit {
    std::uint32_t patch;
    int entered;
    glm::dvec2 point;
  };
  std::vector<Visit> queue{{patch, -1, point}};
  std::unordered_set<std::uint32_t> seen{patch};
  const double cell2 = rows.cell_size * rows.cell_size;
  for (std::size_t next = 0; next < queue.size() && queue.size() < most_patches; ++next) {
    const Visit at = queue[next];
    const Frame& frame = unfolding.frame(at.patch);
    for (int k = 0; k < 3; ++k) {
      if (k == at.entered) continue;
      const std::uint32_t across = unfolding.across(at.patch, k);
      if (across == Adjacency::none) continue;
      const std::uint32_t other = across / 3;
      if (other == except || seen.contains(other)) continue;
      if (squared_distance_to_edge(frame, k, at.point) >= best.distance2 * cell2) continue;
      seen.insert(other);
      const int edge = unfolding.frame_edge(across);
      const glm::dvec2 p = unfold(frame, k, unfolding.frame(other), edge)(at.point);
      search_patch(rows, other, p, best);
      queue.push_back({other, edge, p});
    }
  }
  if (!best.found) return std::nullopt;
  return NearestCell{best.slot, std::sqrt(best.distance2)};
}

}  // namespace verdigris
