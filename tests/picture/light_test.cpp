#include "verdigris/picture/light.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "verdigris/picture/colour.hpp"

namespace verdigris {
namespace {

SceneLight one_light(glm::vec3 towards) {
  return {0.1f, 0.6f, 0.3f, 8.0f, {glm::normalize(towards), {0, 0, 1}}, {1.0f, 0.0f}};
}

TEST(Light, IsTheFormulaOfThePaper) {
  const glm::vec3 n(0, 0, 1), material(0.5f, 0.25f, 1.0f);
  // Light and eye along the normal: every product is 1.
  EXPECT_NEAR(lit(one_light(n), n, n, material).r, 0.5f * (0.1f + 0.6f + 0.3f), 1e-6f);
  // Light at 60 degrees, eye in the mirrored direction: L.N = 1/2, R.E = 1.
  const float s = std::sqrt(3.0f) / 2.0f;
  EXPECT_NEAR(lit(one_light({s, 0, 0.5f}), n, {-s, 0, 0.5f}, material).b, 0.1f + 0.3f + 0.3f, 1e-6f);
  // Eye along the normal: R.E = 1/2.
  EXPECT_NEAR(lit(one_light({s, 0, 0.5f}), n, n, material).b, 0.1f + 0.3f + 0.3f * std::pow(0.5f, 8.0f),
              1e-6f);
  // From behind only the ambient term is left.
  EXPECT_NEAR(lit(one_light({0, 0, -1}), n, n, material).g, 0.25f * 0.1f, 1e-6f);
}

TEST(Light, MovesWithTheCamera) {
  const Camera camera({1, 0, 0}, {0, 1, 0});  // looks along -x: its right is -z
  LightSettings settings;
  settings.sources[0].towards = {2.0f, 0.0f, 0.0f};
  const SceneLight light = place_light(settings, camera);
  EXPECT_NEAR(light.towards[0].z, -1.0f, 1e-6f);
}

TEST(Colour, EncodingRoundTrips) {
  for (int k = 0; k < 256; ++k) {
    const auto c = static_cast<std::uint8_t>(k);
    EXPECT_EQ(from_linear(to_linear({c, c, c, 7}), 7), (Rgba8{c, c, c, 7}));
  }
  EXPECT_NEAR(to_oklab({255, 255, 255, 255}).x, 1.0f, 1e-3f);
  EXPECT_NEAR(colour_difference({255, 255, 255, 255}, {0, 0, 0, 255}), 100.0f, 0.1f);
}

}  // namespace
}  // namespace verdigris
