#pragma once
// Colours as they are stored (sRGB, 8 bits) and as they are computed with (linear light, or Oklab for
// differences).

#include <cstdint>
#include <glm/vec3.hpp>

namespace verdigris {

/// An sRGB-encoded colour with straight alpha: what palettes hold, fields of colours carry and images store.
struct Rgba8 {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

/// One sRGB channel in 0..1 to linear light, and back (IEC 61966-2-1).
float srgb_to_linear(float encoded);
float linear_to_srgb(float linear);

/// Linear light of an 8-bit colour; alpha is left out.
glm::vec3 to_linear(Rgba8 colour);
/// The nearest 8-bit colour, clamped to 0..1.
Rgba8 from_linear(glm::vec3 linear, std::uint8_t alpha = 255);

/// Oklab coordinates (Ottosson 2020): lightness 0..1, green-red, blue-yellow; equal steps look about equal.
glm::vec3 to_oklab(Rgba8 colour);

/// Difference as seen: 100 x distance in Oklab. About 2 is just noticeable side by side, 10 is clearly
/// another colour.
float colour_difference(Rgba8 a, Rgba8 b);

}  // namespace verdigris
