#pragma once
// Values between cells: bilinear means over the cells around a point, ghosts included.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A cell's part in the value of a point.
struct BlendSource {
  std::uint32_t slot;
  float weight;
};

/// The cells that make the value of a point; their weights sum to 1. None: nothing near has a value.
struct CellBlend {
  std::array<BlendSource, 4> cells;
  std::uint8_t count = 0;
};

/// Finds blends anywhere on a surface. Keeps which slots have values at all; shares the surface's data.
class CellBlends {
 public:
  explicit CellBlends(const Surface& surface);

  const Surface& surface() const { return surface_; }
  /// It is owned or repeats one that is; what lies beyond a boundary has none.
  bool has_value(std::uint32_t slot) const { return (known_[slot >> 6] >> (slot & 63)) & 1u; }
  /// The blend at `point`, in grid coordinates of `patch`, model units.
  CellBlend at(std::uint32_t patch, glm::dvec2 point) const;

 private:
  Surface surface_;
  std::vector<std::uint64_t> known_;  // [slot / 64] bit
};

/// Ghosts as interpolated values. For stepping a ghost repeats the cell nearest to it, which may lie up to
/// 0.7 cells aside; where differences between neighbours count, its value is better blended from the cells
/// around the place where it really lies, across the edge.
class GhostBlends {
 public:
  /// Walks to each ghost once. Memory: 52 bytes a ghost.
  explicit GhostBlends(const CellBlends& blends);

  /// Fills the ghosts among `values` [slot] from the owned cells. A second time with `slopes` [slot], the
  /// gradients in model space found from the first: they bridge the gap where cells around a place are
  /// missing.
  void fill(std::span<float> values, std::span<const glm::vec3> slopes = {}) const;

 private:
  struct Ghost {
    std::uint32_t slot;
    CellBlend blend;
    glm::vec3 gap;  // from the middle of the blend to the place itself; 0 where all four cells are there
  };
  Surface surface_;
  std::vector<Ghost> ghosts_;  // ascending by slot
};

}  // namespace verdigris
