#include "verdigris/picture/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "canvas.hpp"

namespace verdigris {

namespace {

constexpr Rgba8 glass{255, 255, 255, 165}, ink{38, 40, 44, 255}, pale{150, 154, 158, 255},
    strong{22, 128, 112, 255};

// A part of a picture, as one of its own.
Image part_of(const Image& image, int left, int top, int width, int height) {
  Image part{width, height, {}};
  for (int y = 0; y < height; ++y) {
    const auto* row =
        image.rgba.data() + 4 * (std::size_t(top + y) * std::size_t(image.width) + std::size_t(left));
    part.rgba.insert(part.rgba.end(), row, row + 4 * std::size_t(width));
  }
  return part;
}

void put_back(Image& image, const Image& part, int left, int top) {
  for (int y = 0; y < part.height; ++y)
    std::copy_n(
        part.rgba.data() + 4 * std::size_t(y) * std::size_t(part.width), 4 * std::size_t(part.width),
        image.rgba.data() + 4 * (std::size_t(top + y) * std::size_t(image.width) + std::size_t(left)));
}

// The curve in a box, from 0 to its greatest value; its strong part ends at `now`.
void draw_curve(Canvas& canvas, const Overlay& overlay, glm::dvec2 low, glm::dvec2 high, double unit) {
  double greatest = 0.0;
  for (const glm::dvec2& p : overlay.points) greatest = std::max(greatest, p.y);
  const double begin = overlay.points.front().x, end = overlay.points.back().x;
  const auto at = [&](glm::dvec2 p) {
    const double x = end > begin ? (p.x - begin) / (end - begin) : 0.0,
                 y = greatest > 0.0 ? p.y / greatest : 0.0;
    return glm::dvec2(low.x + x * (high.x - low.x), low.y + y * (high.y - low.y));
  };
  std::vector<glm::dvec2> past, all;
  for (const glm::dvec2& p : overlay.points) {
    all.push_back(at(p));
    if (p.x <= overlay.now) past.push_back(all.back());
  }
  // The last bit, to a point between two.
  if (!past.empty() && past.size() < all.size()) {
    const glm::dvec2 last = overlay.points[past.size() - 1], next = overlay.points[past.size()];
    past.push_back(at(last + (overlay.now - last.x) / (next.x - last.x) * (next - last)));
  }
  canvas.stroke(std::vector<glm::dvec2>{{low.x, high.y}, low, {high.x, low.y}}, 1.2 * unit, pale);
  canvas.stroke(all, 1.4 * unit, pale);
  if (past.empty()) return;
  canvas.stroke(past, 2.6 * unit, strong);
  canvas.dot(past.back(), 4.0 * unit, strong);
}

}  // namespace

void draw_overlay(Image& image, const Overlay& overlay) {
  if (image.height < 120) return;
  const double unit = image.height / 720.0;
  const bool plot = !overlay.value.empty() && !overlay.points.empty();
  const double time_size = 20.0 * unit, value_size = 13.0 * unit, gap = 14.0 * unit;
  const double inner =
      std::max({text_width(overlay.time, time_size), plot ? text_width(overlay.value, value_size) : 0.0,
                plot ? 220.0 * unit : 0.0});
  const int width = std::min(image.width, static_cast<int>(std::ceil(inner + 2.0 * gap)));
  const int height = static_cast<int>(std::ceil((plot ? 148.0 : 48.0) * unit));
  const int left = std::min(image.width - width, static_cast<int>(24.0 * unit));
  const int top = image.height - height - static_cast<int>(24.0 * unit);
  Canvas canvas(part_of(image, left, top, width, height));
  canvas.fill({0.0, 0.0}, {width, height}, glass);
  canvas.text({gap, gap + time_size}, overlay.time, time_size, ink);
  if (plot) {
    canvas.text({gap, gap + time_size + gap + value_size}, overlay.value, value_size, ink);
    draw_curve(canvas, overlay, {gap, height - gap}, {width - gap, height - gap - 56.0 * unit}, unit);
  }
  put_back(image, canvas.image(), left, top);
}

}  // namespace verdigris
