#pragma once
// What is written over a frame of a film: how much time has passed, and a curve that grows with it.

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "verdigris/picture/image.hpp"

namespace verdigris {

/// A clock and a small plot in the lower left corner of a picture.
struct Overlay {
  std::string time;                    ///< "12.4 years"
  std::string value;                   ///< what the curve has come to: "35 % corroded"; empty: no plot
  std::span<const glm::dvec2> points;  ///< of the whole curve, ascending in x
  double now = 0.0;                    ///< x up to which it is drawn strongly; beyond it is pale
};

/// Draws it over `image`, whose pixels are opaque; sizes follow from the picture's height. The same bits for
/// the same input. Pictures lower than 120 pixels have no room and stay as they are.
void draw_overlay(Image& image, const Overlay& overlay);

}  // namespace verdigris
