#pragma once
// Masks that the model brings along: its colours, and images laid on it by its texture coordinates.

#include <string_view>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A channel of the colours at the model's corners, [slot], as in the file: red, green, blue, alpha, or
/// luminance (Rec. 709 weights on the encoded values). Throws InputError when the model has no colours, and
/// for another channel.
Field<float> colour_mask(const Surface& surface, std::string_view channel);

/// Grey values of an image, rows from top to bottom.
struct ImageValues {
  int width = 0, height = 0;
  std::vector<float> values;  ///< [y * width + x]
};

/// An image by the model's texture coordinates, [slot]: bilinear between the centres of pixels, repeated
/// beyond 0..1; (0, 0) is the lower left corner. No filtering where pixels are finer than cells. Throws
/// InputError when the model has no texture coordinates or the image no pixels.
Field<float> image_mask(const Surface& surface, const ImageValues& image);

}  // namespace verdigris
