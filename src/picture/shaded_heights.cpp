#include "verdigris/picture/shaded_heights.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>

#include "verdigris/picture/palette.hpp"

namespace verdigris {

Image shaded_heights(std::span<const float> heights, int width, int height, double relief) {
  const auto across = static_cast<std::size_t>(std::max(width, 0)),
             down = static_cast<std::size_t>(std::max(height, 0));
  if (heights.empty() || heights.size() != across * down)
    throw std::invalid_argument("not as many heights as the picture has pixels");
  Image image{width, height, std::vector<std::uint8_t>(4 * heights.size())};
  const auto rise = static_cast<float>(relief * width);  // pixels
  const glm::vec3 light = glm::normalize(glm::vec3(-1.0f, 1.0f, 1.4f));
  const float level = light.z;  // what level ground receives
  tbb::parallel_for(std::size_t{0}, down, [&](std::size_t y) {
    const std::size_t above = (y == 0 ? y : y - 1) * across, below = std::min(y + 1, down - 1) * across;
    for (std::size_t x = 0; x < across; ++x) {
      const std::size_t left = x == 0 ? x : x - 1, right = std::min(x + 1, across - 1), here = y * across;
      const auto at = [&](std::size_t k) { return std::clamp(heights[k], 0.0f, 1.0f); };
      const float dx =
          (at(here + right) - at(here + left)) / static_cast<float>(std::max<std::size_t>(right - left, 1));
      const float dy = (at(above + x) - at(below + x)) /
                       static_cast<float>(std::max<std::size_t>((below - above) / across, 1));
      const glm::vec3 normal = glm::normalize(glm::vec3(-rise * dx, -rise * dy, 1.0f));
      // A third of the light comes from everywhere.
      const float shade = 0.35f + 0.65f * std::max(glm::dot(normal, light), 0.0f) / level;
      const glm::vec3 colour = glm::min(to_linear(scalar_colour(heights[here + x])) * shade, glm::vec3(1.0f));
      const Rgba8 c = from_linear(colour);
      std::uint8_t* pixel = &image.rgba[4 * (here + x)];
      pixel[0] = c.r, pixel[1] = c.g, pixel[2] = c.b, pixel[3] = 255;
    }
  });
  return image;
}

}  // namespace verdigris
