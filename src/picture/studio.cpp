// The shader in gl/layer_shader.cpp says the same in GLSL; a test holds both together.
#include "verdigris/picture/studio.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace verdigris {

namespace {

float smooth(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

SceneStudio place_studio(const StudioSettings& settings, const Camera& camera) {
  const auto placed = [&](glm::dvec3 d) {
    return glm::normalize(d.x * camera.right() + d.y * camera.up() + d.z * camera.backward());
  };
  SceneStudio studio{
      settings.floor, settings.horizon, settings.ceiling, glm::vec3(camera.up()), {}, {}, {}, {}};
  for (std::size_t k = 0; k < settings.boxes.size(); ++k) {
    const SoftBox& box = settings.boxes[k];
    const glm::dvec3 towards = placed(box.towards);
    glm::dvec3 across = glm::cross(camera.up(), towards);
    across = glm::length(across) > 1e-6 ? glm::normalize(across) : camera.right();
    studio.towards[k] = towards;
    studio.across[k] = across / static_cast<double>(box.half.x);
    studio.along[k] = glm::cross(towards, across) / static_cast<double>(box.half.y);
    studio.light[k] = box.light;
  }
  return studio;
}

glm::vec3 studio_light(const SceneStudio& studio, glm::vec3 from, float roughness) {
  const float height = glm::dot(from, studio.up);
  const float soft = 0.15f + 0.85f * roughness;
  glm::vec3 sum = glm::mix(studio.floor, studio.horizon, smooth(-0.5f - soft, soft, height));
  sum = glm::mix(sum, studio.ceiling, smooth(-0.2f, 1.0f, height));
  const float edge = 0.10f + 1.60f * roughness;
  for (std::size_t k = 0; k < studio.towards.size(); ++k) {
    const float depth = glm::dot(from, studio.towards[k]);
    if (depth <= 0.0f) continue;
    const float x = std::abs(glm::dot(from, studio.across[k])) / depth;
    const float y = std::abs(glm::dot(from, studio.along[k])) / depth;
    const float cover =
        (1.0f - smooth(1.0f - edge, 1.0f + edge, x)) * (1.0f - smooth(1.0f - edge, 1.0f + edge, y));
    sum += cover * studio.light[k];
  }
  return sum;
}

}  // namespace verdigris
