#pragma once
// The light model of Gobron & Chiba 1999: C = (Ka + Kd (L.N) + Ks (R.E)^n) Cm, negative products taken as 0.

#include <array>
#include <glm/vec3.hpp>

#include "verdigris/picture/camera.hpp"

namespace verdigris {

/// One directional light. It moves with the camera: x to the right, y up, z towards the viewer.
struct LightSource {
  glm::vec3 towards{0.0f, 0.0f, 1.0f};  ///< from the surface to the light, any length, in camera axes
  float strength = 1.0f;                ///< factor on the diffuse and specular terms of this light
};

/// The coefficients, in linear light. The defaults are made for matte label regions: a key light over the
/// viewer's left shoulder that models the form, a weak fill from the lower right that keeps the shadow side
/// readable, and just enough gloss to tell convex from concave. A face square to the key light shows its own
/// colour (sum of terms about 1).
struct LightSettings {
  float ambient = 0.22f;                                                           ///< Ka
  float diffuse = 0.80f;                                                           ///< Kd
  float specular = 0.12f;                                                          ///< Ks
  float shininess = 24.0f;                                                         ///< n
  std::array<LightSource, 2> sources{LightSource{{-0.40f, 0.60f, 0.90f}, 1.0f},    // key
                                     LightSource{{0.85f, -0.15f, 0.60f}, 0.28f}};  // fill
};

/// The same, turned into the world of one camera: what both the CPU and the shader compute with.
struct SceneLight {
  float ambient, diffuse, specular, shininess;
  std::array<glm::vec3, 2> towards;  ///< unit
  std::array<float, 2> strength;
};
SceneLight place_light(const LightSettings& settings, const Camera& camera);

/// The formula for one point: Ka once, the other terms summed over the lights. Linear light in and out; may
/// exceed 1. `normal` and `to_eye` are unit vectors; the normal of a face seen from behind must be turned
/// round before.
glm::vec3 lit(const SceneLight& light, glm::vec3 normal, glm::vec3 to_eye, glm::vec3 material);

}  // namespace verdigris
