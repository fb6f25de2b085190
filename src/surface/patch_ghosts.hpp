#pragma once
// The sources of one patch's ghosts, by unfolding.

#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>

#include "joints.hpp"

namespace verdigris {

// Farther than this, in cells, a cell is no neighbour any more and the ghost stays empty.
constexpr double ghost_reach = 2.5;
constexpr std::size_t ghost_patches = 256;
// Cells; ghosts of the eight neighbours lie no farther beyond an edge.
constexpr double near_by = 1.5;

/// Columns of a row, [begin, end).
struct Columns {
  std::int32_t begin, end;
};

inline Columns columns_of(const Row& row) {
  return {static_cast<std::int32_t>(row.run_begin - row.base),
          static_cast<std::int32_t>(row.run_end - row.base)};
}

inline bool within(const Columns& run, std::int32_t column, std::int32_t margin) {
  return run.begin < run.end && column >= run.begin - margin && column < run.end + margin;
}

/// Calls visit(dx, dy) for the eight neighbours, sides first, until it returns true; returns whether it did.
template <typename Visit>
bool each_neighbour(Visit&& visit) {
  constexpr std::int32_t steps[8][2] = {{0, -1}, {-1, 0}, {1, 0}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const auto& [dx, dy] : steps)
    if (visit(dx, dy)) return true;
  return false;
}

/// Turns the triangles around a patch into its plane.
class PatchGhosts {
 public:
  PatchGhosts(const PatchRows& rows, const Unfolding& unfolding, std::uint32_t patch)
      : rows_(rows),
        unfolding_(unfolding),
        patch_(patch),
        frame_(unfolding.frame(patch)),
        h_(rows.cell_size) {
    for (int k = 0; k < 3; ++k) {
      across_[k] = unfolding.across(patch, k);
      if (across_[k] != Adjacency::none)
        motion_[k] = unfold(frame_, k, unfolding.frame(across_[k] / 3), unfolding.frame_edge(across_[k]));
      const glm::dvec2 a = frame_.corner(k), b = frame_.corner((k + 1) % 3), d = b - a;
      const double length = std::sqrt(d.x * d.x + d.y * d.y);
      outward_[k] = length > 0.0 ? glm::dvec2(d.y, -d.x) / length : glm::dvec2(0.0);
      offset_[k] = outward_[k].x * a.x + outward_[k].y * a.y;
    }
  }

  /// The source of the ghost at (row, column). `try_starts(walk)` calls walk(row, column) for owned cells of
  /// the patch from which the ghost may be seen, the best first, until it returns true.
  template <typename TryStarts>
  std::optional<std::uint32_t> source(std::int32_t row, std::int32_t column, TryStarts&& try_starts,
                                      Joints& joints) const {
    const glm::dvec2 p{(column + 0.5) * h_, (row + 0.5) * h_};
    int exit = 0, beyond = 0;
    double farthest = -1e300;
    for (int k = 0; k < 3; ++k) {
      const double d = outward_[k].x * p.x + outward_[k].y * p.y - offset_[k];
      beyond += d > 1e-9 * h_;
      if (d > farthest) {
        farthest = d;
        exit = k;
      }
    }
    if (beyond <= 1) {
      // The common case: one edge to cross, and the cell around the point beyond it is owned.
      if (across_[exit] == Adjacency::none) return open(joints);
      const std::uint32_t other = across_[exit] / 3;
      const glm::dvec2 q = motion_[exit](p);
      if (const auto slot = owned_at(other, q)) return slot;
      // Straight from the edge, where its foot lies on the edge or, for a cell close by, nearly so.
      const glm::dvec2 foot = p - (farthest + 0.25 * h_) * outward_[exit];
      if (farthest < near_by * h_ || inside(foot))
        if (const auto landing = unfolding_.walk(other, motion_[exit](foot), q))
          return nearest(*landing, joints);
    }
    // Beyond a corner, or the walk met a boundary.
    std::optional<Landing> landing;
    try_starts([&](std::int32_t start_row, std::int32_t start_column) {
      landing = unfolding_.walk(patch_, {(start_column + 0.5) * h_, (start_row + 0.5) * h_}, p);
      return landing.has_value();
    });
    if (landing) return nearest(*landing, joints);
    return open(joints);
  }

 private:
  std::optional<std::uint32_t> owned_at(std::uint32_t patch, glm::dvec2 q) const {
    const double column = std::floor(q.x / h_), row = std::floor(q.y / h_);
    const std::uint32_t first = rows_.row_begin[patch], last = rows_.row_begin[patch + 1];
    if (!(row >= 0.0 && row + 2.0 < static_cast<double>(last - first))) return std::nullopt;
    const std::uint32_t index = first + 1 + static_cast<std::uint32_t>(row);
    const Row& r = rows_.rows[index];
    if (!within(columns_of(r), static_cast<std::int32_t>(column), 0)) return std::nullopt;
    return r.base + static_cast<std::uint32_t>(static_cast<std::int32_t>(column));
  }

  std::optional<std::uint32_t> nearest(const Landing& landing, Joints& joints) const {
    const auto search = [&](std::uint32_t except) {
      return nearest_cell(rows_, unfolding_, landing.patch, landing.point, except, ghost_reach,
                          ghost_patches);
    };
    if (const auto cell = search(patch_)) return cell->slot;
    // Over a shred of surface that owns no cell and leads nowhere else, the ghost repeats a cell of its own
    // patch.
    if (const auto cell = search(no_patch)) return cell->slot;
    ++joints.lost;
    return std::nullopt;
  }

  bool inside(glm::dvec2 p) const {
    for (int k = 0; k < 3; ++k)
      if (outward_[k].x * p.x + outward_[k].y * p.y > offset_[k]) return false;
    return true;
  }

  static std::optional<std::uint32_t> open(Joints& joints) {
    ++joints.open;
    return std::nullopt;
  }

  const PatchRows& rows_;
  const Unfolding& unfolding_;
  std::uint32_t patch_;
  const Frame& frame_;
  double h_;
  std::uint32_t across_[3];
  Motion motion_[3];
  glm::dvec2 outward_[3];
  double offset_[3];
};

}  // namespace verdigris
