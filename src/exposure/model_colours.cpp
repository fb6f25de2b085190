#include "verdigris/exposure/model_colours.hpp"

#include <fmt/format.h>

#include <cmath>

#include "at_cells.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

namespace {

// Values at the corners of triangles, linear in between.
template <typename Value>
auto between_corners(const Surface& surface, std::size_t patch, glm::dvec2 p, Value&& value) {
  const Frame& f = surface.frame(patch);
  const glm::dvec3 w = corner_weights(f, p);
  const auto corner = [&](std::uint8_t k) { return value(3 * patch + (f.first_corner + k) % 3); };
  return w.x * corner(0) + w.y * corner(1) + w.z * corner(2);
}

float sample(const ImageValues& image, glm::dvec2 uv) {
  const double x = uv.x * image.width - 0.5, y = (1.0 - uv.y) * image.height - 0.5;
  const double x0 = std::floor(x), y0 = std::floor(y);
  const auto wrapped = [](double at, int size) {
    const double rest = at - size * std::floor(at / size);
    return std::min(static_cast<int>(rest), size - 1);
  };
  const auto pixel = [&](double px, double py) {
    return static_cast<double>(image.values[static_cast<std::size_t>(wrapped(py, image.height)) *
                                                static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(wrapped(px, image.width))]);
  };
  const double fx = x - x0, fy = y - y0;
  return static_cast<float>((1.0 - fy) * ((1.0 - fx) * pixel(x0, y0) + fx * pixel(x0 + 1, y0)) +
                            fy * ((1.0 - fx) * pixel(x0, y0 + 1) + fx * pixel(x0 + 1, y0 + 1)));
}

}  // namespace

Field<float> colour_mask(const Surface& surface, std::string_view channel) {
  const auto& colours = surface.mesh().corner_color;
  if (colours.empty())
    throw InputError("vertex colours", "the model has none", "use a model with colours, or another mask");
  const auto weights = [&]() -> glm::dvec4 {
    if (channel == "red") return {1, 0, 0, 0};
    if (channel == "green") return {0, 1, 0, 0};
    if (channel == "blue") return {0, 0, 1, 0};
    if (channel == "alpha") return {0, 0, 0, 1};
    if (channel == "luminance") return {0.2126, 0.7152, 0.0722, 0};
    throw InputError("vertex colours", fmt::format("there is no channel '{}'", channel),
                     "choose one of: red, green, blue, alpha, luminance");
  }();
  Field<float> field = at_cells(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    return between_corners(surface, patch, p, [&](std::size_t corner) {
      const glm::vec4& c = colours[corner];
      return weights.x * c.r + weights.y * c.g + weights.z * c.b + weights.w * c.a;
    });
  });
  copy_to_ghosts(surface, field);
  return field;
}

Field<float> image_mask(const Surface& surface, const ImageValues& image) {
  const auto& uv = surface.mesh().corner_uv;
  if (uv.empty())
    throw InputError("image", "the model has no texture coordinates",
                     "use a model that has them, or another mask");
  if (image.width < 1 || image.height < 1 ||
      image.values.size() != static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height))
    throw InputError("image", "it has no pixels", "give an image of at least one pixel");
  Field<float> field = at_cells(surface, [&](std::size_t patch, std::uint32_t, glm::dvec2 p) {
    return sample(image, between_corners(surface, patch, p,
                                         [&](std::size_t corner) { return glm::dvec2(uv[corner]); }));
  });
  copy_to_ghosts(surface, field);
  return field;
}

}  // namespace verdigris
