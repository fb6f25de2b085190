#include "canvas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "stroke_font.hpp"

namespace verdigris {

Canvas::Canvas(int width, int height, Rgba8 background)
    : width_(width),
      height_(height),
      linear_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), to_linear(background)),
      mask_(linear_.size(), 0.0f),
      left_(width),
      right_(0),
      top_(height),
      bottom_(0) {}

Canvas::Canvas(const Image& image) : Canvas(image.width, image.height, Rgba8{}) {
  for (std::size_t k = 0; k < linear_.size(); ++k) {
    const std::uint8_t* p = image.rgba.data() + 4 * k;
    linear_[k] = to_linear(Rgba8{p[0], p[1], p[2], 255});
  }
}

void Canvas::fill(glm::dvec2 from, glm::dvec2 to, Rgba8 colour) {
  const glm::dvec2 low = glm::min(from, to), high = glm::max(from, to);
  const auto overlap = [](double a, double b, int pixel) {
    return static_cast<float>(std::clamp(std::min(b, pixel + 1.0) - std::max(a, double(pixel)), 0.0, 1.0));
  };
  left_ = std::clamp(static_cast<int>(std::floor(low.x)), 0, width_);
  right_ = std::clamp(static_cast<int>(std::ceil(high.x)), 0, width_);
  top_ = std::clamp(static_cast<int>(std::floor(low.y)), 0, height_);
  bottom_ = std::clamp(static_cast<int>(std::ceil(high.y)), 0, height_);
  for (int y = top_; y < bottom_; ++y)
    for (int x = left_; x < right_; ++x)
      mask_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)] =
          overlap(low.x, high.x, x) * overlap(low.y, high.y, y);
  blend(colour);
}

// How much of each pixel lies within `radius` of a segment: as if its edge were straight there.
void Canvas::cover(glm::dvec2 from, glm::dvec2 to, double radius) {
  const double reach = radius + 1.0;
  const int x0 = std::max(0, static_cast<int>(std::floor(std::min(from.x, to.x) - reach)));
  const int x1 = std::min(width_, static_cast<int>(std::ceil(std::max(from.x, to.x) + reach)));
  const int y0 = std::max(0, static_cast<int>(std::floor(std::min(from.y, to.y) - reach)));
  const int y1 = std::min(height_, static_cast<int>(std::ceil(std::max(from.y, to.y) + reach)));
  const glm::dvec2 along = to - from;
  const double squared = glm::dot(along, along);
  // Lines thinner than a pixel are lighter, not thinner.
  const double half = std::max(radius, 0.5), strength = radius / half;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      const glm::dvec2 p = glm::dvec2(x + 0.5, y + 0.5) - from;
      const double t = squared > 0.0 ? std::clamp(glm::dot(p, along) / squared, 0.0, 1.0) : 0.0;
      const double inside = std::clamp(half + 0.5 - glm::length(p - t * along), 0.0, 1.0) * strength;
      float& mask =
          mask_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
      mask = std::max(mask, static_cast<float>(inside));
    }
  left_ = std::min(left_, x0);
  right_ = std::max(right_, x1);
  top_ = std::min(top_, y0);
  bottom_ = std::max(bottom_, y1);
}

void Canvas::blend(Rgba8 colour) {
  // In the encoded values, as screens have always drawn text: in linear light dark letters look thin.
  const float alpha = static_cast<float>(colour.a) / 255.0f;
  const glm::vec3 over(linear_to_srgb(to_linear(colour).r), linear_to_srgb(to_linear(colour).g),
                       linear_to_srgb(to_linear(colour).b));
  for (int y = top_; y < bottom_; ++y)
    for (int x = left_; x < right_; ++x) {
      const std::size_t k =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      if (mask_[k] == 0.0f) continue;
      glm::vec3& under = linear_[k];
      for (int c = 0; c < 3; ++c)
        under[c] = srgb_to_linear(glm::mix(linear_to_srgb(under[c]), over[c], mask_[k] * alpha));
      mask_[k] = 0.0f;
    }
  left_ = width_;
  top_ = height_;
  right_ = bottom_ = 0;
}

void Canvas::stroke(std::span<const glm::dvec2> points, double width, Rgba8 colour) {
  for (std::size_t k = 1; k < points.size(); ++k) cover(points[k - 1], points[k], 0.5 * width);
  blend(colour);
}

void Canvas::dashed(std::span<const glm::dvec2> points, double width, double dash, Rgba8 colour) {
  double walked = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const double length = glm::distance(points[k - 1], points[k]);
    for (double at = 0.0; at < length;) {
      const double phase = std::fmod(walked + at, 2.0 * dash);
      const bool drawn = phase < dash;
      const double end = std::min(length, at + (drawn ? dash : 2.0 * dash) - phase + 1e-9);
      if (drawn)
        cover(glm::mix(points[k - 1], points[k], at / length),
              glm::mix(points[k - 1], points[k], end / length), 0.5 * width);
      at = end;
    }
    walked += length;
  }
  blend(colour);
}

void Canvas::dot(glm::dvec2 centre, double radius, Rgba8 colour) {
  cover(centre, centre, radius);
  blend(colour);
}

void Canvas::text(glm::dvec2 at, std::string_view utf8, double size, Rgba8 colour, double align, bool upwards,
                  double weight) {
  double x = -align * text_width(utf8, size);
  const auto place = [&](glm::dvec2 p) {
    const glm::dvec2 q = p * (size / cap_height) + glm::dvec2(x, 0.0);
    return at + (upwards ? glm::dvec2(-q.y, -q.x) : glm::dvec2(q.x, -q.y));
  };
  while (!utf8.empty()) {
    const Glyph& glyph = glyph_of(next_character(utf8));
    for (const auto& line : glyph.lines)
      for (std::size_t k = 1; k < line.size(); ++k)
        cover(place(line[k - 1]), place(line[k]), 0.5 * weight * size);
    x += glyph.advance * size / cap_height;
  }
  blend(colour);
}

Image Canvas::image() const {
  Image image{width_, height_, {}};
  image.rgba.reserve(4 * linear_.size());
  for (const glm::vec3& pixel : linear_) {
    const Rgba8 c = from_linear(pixel);
    image.rgba.insert(image.rgba.end(), {c.r, c.g, c.b, c.a});
  }
  return image;
}

double text_width(std::string_view utf8, double size) {
  double width = 0.0;
  while (!utf8.empty()) width += glyph_of(next_character(utf8)).advance;
  return width * size / cap_height;
}

}  // namespace verdigris
