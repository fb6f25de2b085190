#pragma once
// Straight walks over the surface: neighbouring triangles are turned about their shared edges into one plane.

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/surface/frame.hpp"

namespace verdigris {

/// Where a walk ended.
struct Landing {
  std::uint32_t patch;
  glm::dvec2 point;  ///< in the plane of `patch`
  Motion motion;     ///< from the plane of the start to the plane of `patch`
};

/// A straight line over the surface, cut at the edges that it crosses.
struct Trace {
  struct Piece {
    std::uint32_t patch;
    glm::dvec2 from, to;  ///< in the plane of `patch`
  };
  std::vector<Piece> pieces;  ///< one at least
  Motion motion;              ///< from the plane of the first piece to that of the last
  bool whole = true;          ///< it goes all the way; otherwise it ends on an edge that cannot be crossed
};

/// The triangles' planes and which of their edges can be crossed; refers to arrays that must outlive it.
class Unfolding {
 public:
  /// `barrier` holds a flag for each half-edge that must not be crossed, or is empty.
  Unfolding(std::span<const Frame> frames, const Adjacency& adjacency, const std::vector<bool>& barrier)
      : frames_(frames), adjacency_(adjacency), barrier_(barrier) {}

  /// All edges can be crossed.
  Unfolding(std::span<const Frame> frames, const Adjacency& adjacency)
      : Unfolding(frames, adjacency, no_barrier()) {}

  const Frame& frame(std::uint32_t patch) const { return frames_[patch]; }

  /// Half-edge of the mesh that is edge k of the frame (0 = AB, 1 = BC, 2 = CA).
  std::uint32_t half_edge(std::uint32_t patch, int k) const {
    return 3 * patch + (static_cast<std::uint32_t>(k) + frames_[patch].first_corner) % 3;
  }
  /// Edge of the frame that a half-edge is.
  int frame_edge(std::uint32_t half_edge) const {
    return static_cast<int>((half_edge % 3 + 3u - frames_[half_edge / 3].first_corner) % 3);
  }
  /// The half-edge across, or Adjacency::none at a boundary or barrier.
  std::uint32_t across(std::uint32_t patch, int k) const {
    const std::uint32_t e = half_edge(patch, k);
    return !barrier_.empty() && barrier_[e] ? Adjacency::none : adjacency_.opposite[e];
  }

  /// Walks straight from `start`, a point in triangle `patch`, to `end`, a point of its plane. Nothing when
  /// the line meets a boundary, a barrier, or more than `most_crossings` edges.
  std::optional<Landing> walk(std::uint32_t patch, glm::dvec2 start, glm::dvec2 end,
                              int most_crossings = 4096) const;

  /// The line itself: as `walk`, but it ends at a boundary or barrier, or after `most_crossings`.
  Trace trace(std::uint32_t patch, glm::dvec2 start, glm::dvec2 end, int most_crossings = 1 << 20) const;

 private:
  static const std::vector<bool>& no_barrier() {
    static const std::vector<bool> none;
    return none;
  }

  // The edge by which the line from `start` to `point`, come in by edge `entered` (-1: it began here), leaves
  // a triangle; -1 when `point` lies in it.
  static int exit_edge(const Frame& frame, int entered, glm::dvec2 start, glm::dvec2 point);

  std::span<const Frame> frames_;
  const Adjacency& adjacency_;
  const std::vector<bool>& barrier_;
};

/// How far `p` lies beyond edge k of a frame: positive outside, in model units.
double beyond_edge(const Frame& frame, int k, glm::dvec2 p);

}  // namespace verdigris
