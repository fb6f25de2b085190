// Light through layers: known answers of the mixture, and of what is mixed.
#include "verdigris/picture/layers.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "verdigris/picture/colour.hpp"

namespace verdigris {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

glm::vec3 mixed(std::vector<glm::vec3> lit, std::vector<float> depths) {
  return mix_layers(lit, depths);
}

void expect_equal(glm::vec3 a, glm::vec3 b, float tolerance = 1e-6f) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], tolerance);
}

const glm::vec3 green(0.1f, 0.6f, 0.4f), copper(0.9f, 0.5f, 0.3f), brown(0.3f, 0.2f, 0.1f);

TEST(Layers, NoUpperLayerShowsTheLower) {
  for (const float b : {1e-6f, 0.3f, 50.0f, infinite})
    expect_equal(mixed({green, copper}, {0.0f, b}), copper);
  expect_equal(mixed({green, brown, copper}, {0.0f, 0.0f, infinite}), copper);
}

TEST(Layers, ThickUpperLayerHidesTheLower) {
  for (const float b : {0.0f, 1.0f, infinite}) expect_equal(mixed({green, copper}, {20.0f, b}), green);
  expect_equal(mixed({green, copper}, {1e6f, 1.0f}), green);
}

TEST(Layers, NothingAtAllIsTheSubstrate) {
  expect_equal(mixed({green, brown, copper}, {0.0f, 0.0f, 0.0f}), copper);
  expect_equal(mixed({copper}, {0.0f}), copper);
}

// The formula of the paper as it stands before its terms are regrouped.
TEST(Layers, TwoAreTheFormulaOfThePaper) {
  for (const double a : {0.01, 0.4, 1.0, 3.0})
    for (const double b : {0.02, 0.7, 5.0}) {
      const glm::dvec3 expected = (glm::dvec3(green) * (1.0 - std::exp(-a)) +
                                   glm::dvec3(copper) * (std::exp(-a) - std::exp(-(a + b)))) /
                                  (1.0 - std::exp(-(a + b)));
      expect_equal(mixed({green, copper}, {static_cast<float>(a), static_cast<float>(b)}), expected, 2e-6f);
    }
}

TEST(Layers, ALayerMayBeCutInTwoAndOrderMatters) {
  expect_equal(mixed({green, green, copper}, {0.3f, 0.5f, 2.0f}), mixed({green, copper}, {0.8f, 2.0f}));
  const glm::vec3 one = mixed({green, brown, copper}, {1.0f, 1.0f, infinite}),
                  other = mixed({brown, green, copper}, {1.0f, 1.0f, infinite});
  EXPECT_GT(glm::distance(one, other), 0.1f);
}

TEST(Layers, MixtureStaysWithinTheLitColours) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  for (int run = 0; run < 2000; ++run) {
    std::vector<glm::vec3> lit;
    std::vector<float> depths;
    for (int k = 0; k < 1 + run % 6; ++k) {
      lit.emplace_back(unit(random), unit(random), unit(random));
      depths.push_back(run % 3 == 0 ? 1e-7f * unit(random) : 4.0f * unit(random) * unit(random));
    }
    const glm::vec3 c = mix_layers(lit, depths);
    for (int channel = 0; channel < 3; ++channel) {
      float low = 2.0f, high = -1.0f;
      for (const glm::vec3& l : lit) {
        low = std::min(low, l[channel]);
        high = std::max(high, l[channel]);
      }
      ASSERT_GE(c[channel], low - 1e-5f);
      ASSERT_LE(c[channel], high + 1e-5f);
    }
  }
}

TEST(Layers, OpacityDeepensAThickness) {
  LayerLook look = crust_look(green, 0.8f, 0.0f);
  EXPECT_FLOAT_EQ(optical_depth(look, 2.0f), 2.0f);
  look.opacity = 0.75f;
  EXPECT_FLOAT_EQ(optical_depth(look, 2.0f), 8.0f);
  look.clear_depth = 4.0f;
  EXPECT_FLOAT_EQ(optical_depth(look, 2.0f), 2.0f);
  EXPECT_EQ(optical_depth(look, -1.0f), 0.0f);
}

struct Scene {
  Camera camera{{0, 0, 1}, {0, 1, 0}};
  SceneLight light = place_light({}, camera);
  SceneStudio studio = place_studio({}, camera);
};

TEST(Layers, WithoutMirrorALayerIsLitByTheFormulaOfThePaper) {
  const Scene scene;
  LayerLook look = crust_look(brown, 0.6f, 0.5f);
  look.mirror = 0.0f;
  SceneLight own = scene.light;
  own.ambient = look.ambient;
  own.diffuse = look.diffuse;
  own.specular = look.specular;
  own.shininess = look.shininess;
  const glm::vec3 n = glm::normalize(glm::vec3(0.3f, 0.2f, 0.9f)), e(0, 0, 1);
  expect_equal(lit_layer(look, 0.0f, scene.light, scene.studio, n, e), lit(own, n, e, brown));
}

TEST(Layers, ShinyMetalUnderThinPatinaIsShiny) {
  const Scene scene;
  LayerStack stack;
  stack.layers = {crust_look(green, 0.9f, 0.5f)};
  stack.substrate = metal_look(copper, 0.1f);
  // Mirror images have edges, matte surfaces none: the steepest change of light over a hundredth of a radian,
  // relative to the light itself.
  const auto sharpness = [&](float micrometres) {
    LayerCell cell;
    cell.depth[0] = LayerCell::packed(optical_depth(stack.layers[0], micrometres));
    float last = 0.0f, steepest = 0.0f;
    for (float angle = -1.2f; angle < 1.2f; angle += 0.01f) {
      const glm::vec3 n(std::sin(angle), 0.5f * std::cos(angle), std::cos(angle));
      const float now = lit_cell(stack, cell, scene.light, scene.studio, glm::normalize(n), {0, 0, 1}).r;
      if (last > 0.0f) steepest = std::max(steepest, std::abs(now - last) / now);
      last = now;
    }
    return steepest;
  };
  EXPECT_GT(sharpness(0.0f), 0.04f);
  EXPECT_GT(sharpness(0.1f), 0.7f * sharpness(0.0f));
  EXPECT_LT(sharpness(20.0f), 0.4f * sharpness(0.0f));
}

TEST(Layers, PackedDepthsAreFineEnoughForTheScreen) {
  for (int k = 0; k < 4000; ++k) {
    const float depth = 0.004f * static_cast<float>(k);
    const float back = static_cast<float>(LayerCell::packed(depth)) * (LayerCell::most_depth / 65535.0f);
    const glm::vec3 exact = mixed({green, copper}, {depth, infinite}),
                    packed = mixed({green, copper}, {back, infinite});
    EXPECT_LT(glm::distance(exact, packed), 0.1f / 255.0f);
  }
}

TEST(Layers, WhereMetalIsGoneSomethingElseStands) {
  const Scene scene;
  LayerStack stack;
  LayerCell cell;
  cell.present = 0;
  const glm::vec3 n(0, 0, 1);
  expect_equal(lit_cell(stack, cell, scene.light, scene.studio, n, n),
               lit_layer(stack.gone, 0.0f, scene.light, scene.studio, n, n));
}

TEST(Studio, RoughnessBlursAndMatteIsEven) {
  const Scene scene;
  const auto range = [&](float roughness) {
    float low = 1e9f, high = 0.0f;
    for (float a = -3.1f; a < 3.1f; a += 0.01f)
      for (const float y : {-0.5f, 0.0f, 0.6f}) {
        const float l =
            studio_light(scene.studio, glm::normalize(glm::vec3(std::sin(a), y, std::cos(a))), roughness).g;
        EXPECT_GE(l, 0.0f);
        low = std::min(low, l);
        high = std::max(high, l);
      }
    return high - low;
  };
  EXPECT_GT(range(0.0f), 1.0f);
  EXPECT_LT(range(1.0f), 0.75f * range(0.0f));
}

}  // namespace
}  // namespace verdigris
