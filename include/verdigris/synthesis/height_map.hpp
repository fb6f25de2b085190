#pragma once
// A scalar field seen as a height field: its values on a grid.

#include <cstddef>
#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris {

/// Values on a grid of square samples, rows from the top (greatest y) to the bottom, as in a picture.
struct HeightMap {
  int width = 0, height = 0;
  double step = 1.0;          ///< distance of neighbouring samples, units of the field
  std::vector<float> values;  ///< [y * width + x]

  float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The part of the plane z = `section` that a field's window shows, at the middles of `width` x `height`
/// samples, all of the window in view and none of it distorted; finer detail than the samples show is left
/// out. A field that repeats with its window gives a picture that repeats, if square. The same bits for any
/// number of threads. Throws std::invalid_argument for less than one sample.
HeightMap sample_heights(const ScalarField& field, int width, int height, double section);

}  // namespace verdigris
