#pragma once
// Lines and letters on an image, antialiased.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "verdigris/picture/colour.hpp"
#include "verdigris/picture/image.hpp"

namespace verdigris {

/// A picture to draw on. Pixel coordinates: x to the right, y down, (0.5, 0.5) the middle of the first pixel.
class Canvas {
 public:
  Canvas(int width, int height, Rgba8 background);
  /// Over a picture, whose alpha does not count.
  explicit Canvas(const Image& image);

  void fill(glm::dvec2 from, glm::dvec2 to, Rgba8 colour);
  /// A line through `points` with round ends and joints. Where it touches itself it is not darker.
  void stroke(std::span<const glm::dvec2> points, double width, Rgba8 colour);
  /// Dashes of so many pixels and gaps as long.
  void dashed(std::span<const glm::dvec2> points, double width, double dash, Rgba8 colour);
  void dot(glm::dvec2 centre, double radius, Rgba8 colour);
  /// Capitals are `size` high. `align` is the part of the text's width left of `at` (0 left, 0.5 centred, 1
  /// right); `at` lies on the base line. `upwards` turns it a quarter to the left.
  void text(glm::dvec2 at, std::string_view utf8, double size, Rgba8 colour, double align = 0.0,
            bool upwards = false, double weight = 0.115);

  Image image() const;

 private:
  void cover(glm::dvec2 from, glm::dvec2 to, double radius);
  void blend(Rgba8 colour);

  int width_, height_;
  std::vector<glm::vec3> linear_;  // linear light
  std::vector<float> mask_;        // coverage of what is being drawn
  int left_, right_, top_, bottom_;
};

/// Width of a text whose capitals are `size` high.
double text_width(std::string_view utf8, double size);

}  // namespace verdigris
