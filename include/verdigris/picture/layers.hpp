#pragma once
// Light through layers: each is lit first, then they are mixed by how much light they let through.
// Source: Gobron & Chiba 1999, "Rendering problem: light through two layers", carried on to n layers.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/picture/light.hpp"
#include "verdigris/picture/studio.hpp"

namespace verdigris {

/// How one layer looks. Light on it is the paper's (Ka + Kd (L.N) + Ks (R.E)^n) Cm; `mirror` adds what it
/// reflects of the studio, and is 0 in the paper. A metal mirrors in its own colour, anything else in white.
struct LayerLook {
  glm::vec3 colour{0.5f};      ///< Cm, linear light
  glm::vec3 far_colour{0.5f};  ///< Cm where LayerCell::tint is 255: a patina is never of one colour
  float opacity = 0.5f;        ///< o of the paper, 0 <= o < 1
  float clear_depth = 1.0f;    ///< micrometres through which a layer of opacity 0 lets 1/e of the light
  float ambient = 0.22f, diffuse = 0.80f;     ///< Ka, Kd
  float specular = 0.06f, shininess = 12.0f;  ///< Ks, n
  float mirror = 0.0f;                        ///< share of the studio that is reflected
  float roughness = 0.5f;                     ///< 0 mirror .. 1 matte: how blurred it is
  float metallic = 0.0f;                      ///< 0..1: the mirror image takes on its colour
};

/// Looks of common kinds. `roughness` 0..1 sets highlight and mirror image.
LayerLook metal_look(glm::vec3 colour, float roughness);
LayerLook crust_look(glm::vec3 colour, float roughness, float opacity, float clear_depth = 1.0f);

/// a = t / (1 - o) of the paper, for a thickness in micrometres; 0 or more.
float optical_depth(const LayerLook& look, float micrometres);

/// Light that the layer alone sends to the eye. Linear; may exceed 1. Unit vectors, as for `lit`. `open` is
/// the share of its surroundings that the place sees (ambient occlusion): a factor on Ka and the mirror
/// image, and on half of what comes from the lamps; 1 is the paper's light.
glm::vec3 lit_layer(const LayerLook& look, float tint, const SceneLight& light, const SceneStudio& studio,
                    glm::vec3 normal, glm::vec3 to_eye, float open = 1.0f);

/// c = sum l_i (e^-A(i-1) - e^-A(i)) / (1 - e^-A(n)), A(i) the sum of the optical depths of layers 1..i, for
/// any number of layers, the uppermost first. With two it is the paper's formula. The last may be infinitely
/// deep: a substrate, through which nothing shows; then the denominator is 1. Where all depths are 0 the
/// answer is the last layer. `lit` and `depths` are of one size, at least 1.
glm::vec3 mix_layers(std::span<const glm::vec3> lit, std::span<const float> depths);

/// Layers over the substrate that pictures can hold, beside any number in mix_layers.
inline constexpr std::size_t most_layers = 4;

/// What a picture needs of a cell. Depths stop at the one through which nothing shows any more.
struct LayerCell {
  static constexpr float most_depth = 12.0f;  ///< e^-12: a 40th of the smallest step of 8 bits in the dark
  std::array<std::uint16_t, most_layers> depth{};  ///< optical, uppermost first; 65535 is most_depth
  std::uint8_t present = 255;                      ///< 0: its metal is gone
  std::uint8_t tint = 0;                           ///< between LayerLook::colour and far_colour

  std::uint8_t open = 255;  ///< share of its surroundings it sees, see lit_layer

  static std::uint16_t packed(float depth);
  friend bool operator==(const LayerCell&, const LayerCell&) = default;
};

/// All layers of a surface: from the uppermost down, then the substrate, which shows where all are thin and
/// through which nothing does; and what stands in its place where it is gone.
struct LayerStack {
  std::vector<LayerLook> layers;  ///< most_layers at most
  LayerLook substrate = metal_look({0.95f, 0.64f, 0.54f}, 0.25f);
  LayerLook gone = crust_look({0.035f, 0.032f, 0.03f}, 0.9f, 0.9f);
};

/// The colour of a cell under light: what the shader of the renderer draws, to 1/255.
glm::vec3 lit_cell(const LayerStack& stack, const LayerCell& cell, const SceneLight& light,
                   const SceneStudio& studio, glm::vec3 normal, glm::vec3 to_eye);

struct BandMesh;
/// Vertex values from those of the slots [slot]: copies at centres, means at contour points. `out` has one
/// element a vertex.
void layer_bands(const BandMesh& bands, std::span<const LayerCell> slots, std::span<LayerCell> out);

}  // namespace verdigris
