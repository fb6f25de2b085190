// Sources: IEC 61966-2-1 (sRGB); B. Ottosson, "A perceptual color space for image processing", 2020 (Oklab).
#include "verdigris/picture/colour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace verdigris {

float srgb_to_linear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float linear_to_srgb(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

namespace {

std::array<float, 256> decoding_table() {
  std::array<float, 256> table{};
  for (std::size_t k = 0; k < table.size(); ++k) table[k] = srgb_to_linear(static_cast<float>(k) / 255.0f);
  return table;
}

std::uint8_t encode(float linear) {
  return static_cast<std::uint8_t>(linear_to_srgb(std::clamp(linear, 0.0f, 1.0f)) * 255.0f + 0.5f);
}

}  // namespace

glm::vec3 to_linear(Rgba8 colour) {
  static const std::array<float, 256> table = decoding_table();
  return {table[colour.r], table[colour.g], table[colour.b]};
}

Rgba8 from_linear(glm::vec3 linear, std::uint8_t alpha) {
  return {encode(linear.r), encode(linear.g), encode(linear.b), alpha};
}

glm::vec3 to_oklab(Rgba8 colour) {
  const glm::vec3 c = to_linear(colour);
  const float l = std::cbrt(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
  const float m = std::cbrt(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
  const float s = std::cbrt(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
  return {0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s,
          1.9779984951f * l - 2.4285922050f * m + 0.4505937099f * s,
          0.0259040371f * l + 0.7827717662f * m - 0.8086757660f * s};
}

float colour_difference(Rgba8 a, Rgba8 b) {
  return 100.0f * glm::distance(to_oklab(a), to_oklab(b));
}

}  // namespace verdigris
