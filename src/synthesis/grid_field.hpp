#pragma once
// A grid of heights as a smooth scalar field.

#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris::synthesis {

/// What lies beyond the unit square (or the unit interval).
enum class Beyond : std::uint8_t {
  repeat,  ///< the same again; the last row and column equal the first
  mirror,  ///< the same, mirrored: no step at the border
  zero,
};

/// Values on a grid of columns x rows points over [0, 1]^2 (rows = 1: over [0, 1]), interpolated by
/// Catmull-Rom splines: through every value, with a continuous slope. Values must lie in 0..1 and so does the
/// field. Coarser grids, each half the one before, serve wide footprints.
class GridField final : public ScalarField {
 public:
  /// `window`: where the unit square lies in space, affine, axis by axis; with an extent along x and y.
  GridField(std::vector<float> values, int columns, int rows, Beyond beyond,
            const Window& window = {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0}});

  ValueRange range() const override { return {0.0f, 1.0f, true}; }
  Window window() const override { return window_; }

 private:
  struct Level {
    std::vector<float> values;
    int columns, rows;
  };
  void compute(const Points& points, double footprint, std::span<float> out) const override;
  double sample(const Level& level, double x, double y) const;
  Level half(const Level& level) const;

  std::vector<Level> levels_;
  Beyond beyond_;
  Window window_;
};

/// Shifts and scales to 0..1; equal values become 0.5.
std::vector<float> to_unit_range(const std::vector<double>& values);

}  // namespace verdigris::synthesis
