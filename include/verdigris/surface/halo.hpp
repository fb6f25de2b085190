#pragma once
// What lies around each patch up to some cells away: for behaviours whose neighbourhood reaches farther than
// the eight cells around a cell.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A cell beyond a patch and the owned cell that lies there when the surface around is unfolded into its
/// plane.
struct HaloCell {
  std::uint32_t offset;  ///< in the patch's raster: row * width + column
  std::uint32_t source;  ///< slot
};

/// For each patch a *raster*: its grid with `reach` rows and columns around it. Its own cells lie in it, and
/// those of other patches within `reach` of them (on both axes), found as ghosts are: by walking straight
/// from the patch, each one the owned cell nearest. Beyond a boundary or barrier there is none. Made once,
/// then const. Memory: 8 bytes a halo cell.
class Halo {
 public:
  struct Patch {
    std::size_t begin;            ///< first of its halo cells
    std::int32_t left;            ///< grid column of raster column 0; raster row 0 is grid row -reach
    std::uint32_t width, height;  ///< 0 for a patch without cells
  };

  /// The surface must outlive it. Throws InputError when triangles are so small beside the reach that more
  /// than a hundred halo cells came on each cell or 8 GB in all, std::invalid_argument unless links are
  /// unfolded and reach is 1 or more.
  Halo(const Surface& surface, unsigned reach);

  const Surface& surface() const { return surface_; }
  unsigned reach() const { return reach_; }
  const Patch& patch(std::size_t p) const { return patches_[p]; }
  std::span<const HaloCell> cells(std::size_t p) const {
    return {cells_.data() + patches_[p].begin, cells_.data() + patches_[p + 1].begin};
  }
  std::size_t bytes() const { return patches_.size() * sizeof(Patch) + cells_.size() * sizeof(HaloCell); }

 private:
  const Surface& surface_;
  unsigned reach_;
  std::vector<Patch> patches_;  // one more at the end
  std::vector<HaloCell> cells_;
};

}  // namespace verdigris
