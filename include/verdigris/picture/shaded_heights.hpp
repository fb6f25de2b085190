#pragma once
// Heights as a map: coloured by height, lit from the upper left.

#include <span>

#include "verdigris/picture/image.hpp"

namespace verdigris {

/// A picture of `heights` [y * width + x], 0 (deep verdigris) to 1 (pale gold), clamped; `relief` is how high
/// 1 stands, as a share of the width, for light and shade; 0: none. Throws std::invalid_argument when there
/// are not as many as the size says.
Image shaded_heights(std::span<const float> heights, int width, int height, double relief = 0.15);

}  // namespace verdigris
