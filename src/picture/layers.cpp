// Source: S. Gobron, N. Chiba, "3D Surface Cellular Automata and Their Applications", 1999, "Light through
// two layers". The regrouped form printed there has (l1 - l2) e^-a; its own integral gives (l2 - l1) e^-a.
#include "verdigris/picture/layers.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "verdigris/picture/bands.hpp"

namespace verdigris {

LayerLook metal_look(glm::vec3 colour, float roughness) {
  LayerLook look;
  look.colour = look.far_colour = colour;
  look.metallic = 1.0f;
  look.opacity = 0.99f;
  look.roughness = roughness;
  // Hardly any light enters a metal: nearly all that it sends is mirrored. The highlight narrows with polish.
  look.ambient = 0.02f;
  look.diffuse = 0.06f + 0.30f * roughness;
  look.specular = 0.30f;
  look.shininess = 4.0f + 90.0f * (1.0f - roughness) * (1.0f - roughness);
  look.mirror = 1.0f - 0.35f * roughness;
  return look;
}

LayerLook crust_look(glm::vec3 colour, float roughness, float opacity, float clear_depth) {
  LayerLook look;
  look.colour = look.far_colour = colour;
  look.roughness = roughness;
  look.opacity = opacity;
  look.clear_depth = clear_depth;
  const float polish = 1.0f - roughness;
  look.specular = 0.02f + 0.25f * polish * polish;
  look.shininess = 4.0f + 60.0f * polish * polish;
  look.mirror = 0.06f * polish;
  return look;
}

float optical_depth(const LayerLook& look, float micrometres) {
  return std::max(micrometres, 0.0f) / (look.clear_depth * (1.0f - look.opacity));
}

glm::vec3 lit_layer(const LayerLook& look, float tint, const SceneLight& light, const SceneStudio& studio,
                    glm::vec3 normal, glm::vec3 to_eye, float open) {
  const glm::vec3 colour = glm::mix(look.colour, look.far_colour, tint);
  SceneLight own = light;
  const float lamps = 0.5f + 0.5f * open;
  own.ambient = open * look.ambient;
  own.diffuse = lamps * look.diffuse;
  own.specular = lamps * look.specular;
  own.shininess = look.shininess;
  const glm::vec3 sum = lit(own, normal, to_eye, colour);
  if (look.mirror <= 0.0f) return sum;
  const float facing = glm::dot(normal, to_eye);
  const glm::vec3 mirrored = 2.0f * facing * normal - to_eye;
  // Schlick 1994: everything mirrors more, and in white, where it is seen at a grazing angle.
  const float grazing = std::pow(1.0f - std::max(facing, 0.0f), 5.0f) * (1.0f - look.roughness);
  const glm::vec3 tinted = glm::mix(glm::vec3(1.0f), colour, look.metallic * (1.0f - grazing));
  return sum + open * look.mirror * tinted * studio_light(studio, mirrored, look.roughness);
}

glm::vec3 mix_layers(std::span<const glm::vec3> lit, std::span<const float> depths) {
  assert(!lit.empty() && lit.size() == depths.size());
  glm::vec3 sum(0.0f);
  float above = 0.0f;
  for (std::size_t k = 0; k < lit.size(); ++k) {
    // e^-A - e^-(A + a), exact for the thinnest films too.
    sum += std::exp(-above) * -std::expm1(-depths[k]) * lit[k];
    above += depths[k];
  }
  return above > 0.0f ? sum / -std::expm1(-above) : lit.back();
}

std::uint16_t LayerCell::packed(float depth) {
  return static_cast<std::uint16_t>(std::clamp(depth / most_depth, 0.0f, 1.0f) * 65535.0f + 0.5f);
}

glm::vec3 lit_cell(const LayerStack& stack, const LayerCell& cell, const SceneLight& light,
                   const SceneStudio& studio, glm::vec3 normal, glm::vec3 to_eye) {
  assert(stack.layers.size() <= most_layers);
  const float tint = static_cast<float>(cell.tint) / 255.0f,
              present = static_cast<float>(cell.present) / 255.0f;
  const auto of = [&](const LayerLook& look) {
    return lit_layer(look, tint, light, studio, normal, to_eye, static_cast<float>(cell.open) / 255.0f);
  };
  std::array<glm::vec3, most_layers + 1> lights;
  std::array<float, most_layers + 1> depths;
  const std::size_t count = stack.layers.size();
  for (std::size_t k = 0; k < count; ++k) {
    lights[k] = of(stack.layers[k]);
    depths[k] = static_cast<float>(cell.depth[k]) * (LayerCell::most_depth / 65535.0f);
  }
  lights[count] = of(stack.substrate);
  depths[count] = std::numeric_limits<float>::infinity();
  const glm::vec3 whole = mix_layers(std::span(lights).first(count + 1), std::span(depths).first(count + 1));
  return present < 1.0f ? glm::mix(of(stack.gone), whole, present) : whole;
}

void layer_bands(const BandMesh& bands, std::span<const LayerCell> slots, std::span<LayerCell> out) {
  for (const CentreRun& run : bands.centres) {
    const auto from = slots.subspan(run.slot, run.count);
    std::copy(from.begin(), from.end(), out.begin() + run.vertex);
  }
  for (const ContourRun& run : bands.contours)
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const std::uint32_t begin = bands.blend_begin[run.blend + k],
                          end = bands.blend_begin[run.blend + k + 1];
      LayerCell& cell = out[run.vertex + k];
      cell = begin == end ? LayerCell{} : slots[bands.blends[begin].slot];
      bool uniform = true;
      for (std::uint32_t n = begin + 1; n < end; ++n) uniform &= slots[bands.blends[n].slot] == cell;
      if (uniform) continue;
      std::array<float, most_layers> depth{};
      float present = 0.0f, tint = 0.0f, open = 0.0f;
      for (std::uint32_t n = begin; n < end; ++n) {
        const LayerCell& from = slots[bands.blends[n].slot];
        const float weight = bands.blends[n].weight;
        for (std::size_t l = 0; l < most_layers; ++l) depth[l] += weight * static_cast<float>(from.depth[l]);
        present += weight * static_cast<float>(from.present);
        tint += weight * static_cast<float>(from.tint);
        open += weight * static_cast<float>(from.open);
      }
      for (std::size_t l = 0; l < most_layers; ++l)
        cell.depth[l] = static_cast<std::uint16_t>(std::min(depth[l] + 0.5f, 65535.0f));
      cell.present = static_cast<std::uint8_t>(std::min(present + 0.5f, 255.0f));
      cell.tint = static_cast<std::uint8_t>(std::min(tint + 0.5f, 255.0f));
      cell.open = static_cast<std::uint8_t>(std::min(open + 0.5f, 255.0f));
    }
}

}  // namespace verdigris
