#include "verdigris/picture/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace verdigris {

namespace {

// Two rings of hues in Oklab (lightness near 0.62 and 0.76, chroma 0.05 to 0.11), warm ones a little stronger
// than cold ones; chosen by eye for neighbours on a map, then moved apart until every two differed by 8.
constexpr std::array<Rgba8, 16> regions{{
    {181, 107, 58, 255},   // copper
    {114, 161, 149, 255},  // verdigris
    {225, 191, 100, 255},  // brass
    {84, 112, 156, 255},   // slate blue
    {156, 194, 148, 255},  // sage
    {192, 99, 112, 255},   // oxide red
    {148, 196, 218, 255},  // mist
    {127, 131, 78, 255},   // olive
    {238, 154, 110, 255},  // terracotta
    {150, 110, 166, 255},  // plum
    {121, 168, 90, 255},   // moss
    {220, 155, 178, 255},  // rose
    {36, 145, 166, 255},   // lagoon
    {163, 160, 212, 255},  // lilac
    {192, 148, 56, 255},   // ochre
    {216, 196, 180, 255},  // limestone
}};

}  // namespace

std::span<const Rgba8> region_palette() {
  return regions;
}

std::vector<Rgba8> assign_colours(std::int32_t count, std::span<const LabelPair> touching,
                                  std::span<const Rgba8> palette) {
  constexpr float clear = 12.0f;   // neighbours should differ by so much whatever it costs
  constexpr float enough = 18.0f;  // beyond this difference a pair is simply different; evenness then decides
  const auto n = static_cast<std::size_t>(std::max(count, 0));
  const std::size_t colours = palette.size();
  std::vector<std::uint32_t> begin(n + 1, 0);
  for (const auto& [a, b] : touching) {
    ++begin[static_cast<std::size_t>(a)];
    ++begin[static_cast<std::size_t>(b)];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& start : begin) sum += std::exchange(start, sum);
  std::vector<std::uint32_t> neighbours(sum), fill(begin.begin(), begin.end());
  for (const auto& [a, b] : touching) {
    neighbours[fill[static_cast<std::size_t>(a)]++] = static_cast<std::uint32_t>(b);
    neighbours[fill[static_cast<std::size_t>(b)]++] = static_cast<std::uint32_t>(a);
  }
  std::vector<float> difference(colours * colours);
  for (std::size_t a = 0; a < colours; ++a)
    for (std::size_t b = 0; b < colours; ++b)
      difference[a * colours + b] = colour_difference(palette[a], palette[b]);

  std::vector<std::uint32_t> order(n);
  for (std::uint32_t k = 0; k < n; ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return begin[a + 1] - begin[a] > begin[b + 1] - begin[b];
  });
  constexpr std::uint8_t none = 255;
  std::vector<std::uint8_t> chosen(n, none);
  std::vector<std::size_t> used(colours, 0);
  std::vector<float> nearest(colours);
  for (std::size_t done = 0; done < n; ++done) {
    const std::uint32_t label = order[done];
    std::fill(nearest.begin(), nearest.end(), enough);
    for (std::uint32_t k = begin[label]; k < begin[label + 1]; ++k)
      if (const std::uint8_t other = chosen[neighbours[k]]; other != none)
        for (std::size_t c = 0; c < colours; ++c)
          nearest[c] = std::min(nearest[c], difference[other * colours + c]);
    // One use more than average costs as much as a difference of 2: the palette stays even, but never at the
    // price of equal neighbours.
    const float average = static_cast<float>(done) / static_cast<float>(colours);
    std::size_t best = 0;
    float best_score = -1e30f;
    for (std::size_t c = 0; c < colours; ++c) {
      const float excess = std::clamp(static_cast<float>(used[c]) - average, -4.0f, 4.0f);
      const float score = nearest[c] - 2.0f * excess - 20.0f * std::max(clear - nearest[c], 0.0f);
      if (score > best_score) best_score = score, best = c;
    }
    chosen[label] = static_cast<std::uint8_t>(best);
    ++used[best];
  }
  std::vector<Rgba8> result(n);
  for (std::size_t k = 0; k < n; ++k) result[k] = palette[chosen[k]];
  return result;
}

Rgba8 scalar_colour(float value) {
  // Knots in Oklab, lightness in equal steps; between them straight lines in that space.
  static constexpr std::array<glm::vec3, 7> knots{{{0.22f, -0.030f, -0.030f},
                                                   {0.34f, -0.058f, -0.028f},
                                                   {0.46f, -0.070f, 0.005f},
                                                   {0.58f, -0.030f, 0.060f},
                                                   {0.70f, 0.050f, 0.090f},
                                                   {0.82f, 0.035f, 0.095f},
                                                   {0.94f, 0.000f, 0.060f}}};
  if (std::isnan(value)) return unlabelled;
  const float x = std::clamp(value, 0.0f, 1.0f) * static_cast<float>(knots.size() - 1);
  const auto k = std::min(static_cast<std::size_t>(x), knots.size() - 2);
  const glm::vec3 lab = glm::mix(knots[k], knots[k + 1], x - static_cast<float>(k));
  const float l = lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z;
  const float m = lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z;
  const float s = lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z;
  const float l3 = l * l * l, m3 = m * m * m, s3 = s * s * s;
  return from_linear({4.0767416621f * l3 - 3.3077115913f * m3 + 0.2309699292f * s3,
                      -1.2684380046f * l3 + 2.6097574011f * m3 - 0.3413193965f * s3,
                      -0.0041960863f * l3 - 0.7034186147f * m3 + 1.7076147010f * s3});
}

}  // namespace verdigris
