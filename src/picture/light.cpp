// Source: S. Gobron, N. Chiba, "3D Surface Cellular Automata and Their Applications", 1999, "Simple Light
// Model".
#include "verdigris/picture/light.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace verdigris {

SceneLight place_light(const LightSettings& settings, const Camera& camera) {
  SceneLight light{settings.ambient, settings.diffuse, settings.specular, settings.shininess, {}, {}};
  for (std::size_t k = 0; k < settings.sources.size(); ++k) {
    const glm::dvec3 d = settings.sources[k].towards;
    light.towards[k] = glm::normalize(d.x * camera.right() + d.y * camera.up() + d.z * camera.backward());
    light.strength[k] = settings.sources[k].strength;
  }
  return light;
}

glm::vec3 lit(const SceneLight& light, glm::vec3 normal, glm::vec3 to_eye, glm::vec3 material) {
  float sum = light.ambient;
  for (std::size_t k = 0; k < light.towards.size(); ++k) {
    const float incidence = glm::dot(light.towards[k], normal);
    const glm::vec3 reflected = 2.0f * incidence * normal - light.towards[k];
    const float gloss = std::max(glm::dot(reflected, to_eye), 0.0f);
    sum += light.strength[k] *
           (light.diffuse * std::max(incidence, 0.0f) + light.specular * std::pow(gloss, light.shininess));
  }
  return sum * material;
}

}  // namespace verdigris
