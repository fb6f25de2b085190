#pragma once
// What metal mirrors: a small photographer's studio of soft boxes before a grey gradient, as a closed
// formula.

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "verdigris/picture/camera.hpp"

namespace verdigris {

/// A rectangular lamp, far away. Directions are in camera axes: x to the right, y up, z towards the viewer.
struct SoftBox {
  glm::vec3 towards{0.0f, 0.0f, 1.0f};  ///< to its middle, any length
  glm::vec2 half{0.5f, 0.5f};           ///< half its width and height, as tangents of angles
  glm::vec3 light{1.0f};                ///< linear light it sends
};

/// The room, which moves with the camera as the lights of LightSettings do. The defaults: a large warm box
/// over the viewer's left shoulder, a tall cool strip on the right, a low one behind on the left that draws
/// the outline, and dark walls between them, for metal is known by its contrasts.
struct StudioSettings {
  glm::vec3 floor{0.46f, 0.43f, 0.40f}, horizon{0.70f, 0.69f, 0.67f}, ceiling{0.86f, 0.88f, 0.92f};
  std::array<SoftBox, 3> boxes{SoftBox{{-0.75f, 0.85f, 0.80f}, {0.55f, 0.50f}, {1.10f, 1.04f, 0.95f}},
                               SoftBox{{1.00f, 0.20f, 0.45f}, {0.25f, 1.00f}, {0.50f, 0.55f, 0.64f}},
                               SoftBox{{-0.95f, 0.10f, -0.45f}, {0.25f, 0.90f}, {0.55f, 0.54f, 0.52f}}};
};

/// The same, turned into the world of one camera: what both the CPU and the shader compute with.
struct SceneStudio {
  glm::vec3 floor, horizon, ceiling;
  glm::vec3 up;                            ///< unit
  std::array<glm::vec3, 3> towards;        ///< unit
  std::array<glm::vec3, 3> across, along;  ///< unit over half size: a box spans -1..1 in both
  std::array<glm::vec3, 3> light;
};
SceneStudio place_studio(const StudioSettings& settings, const Camera& camera);

/// Light that comes from the unit direction `from`, as a surface of `roughness` (0 mirror .. 1 matte) sees
/// it: edges of boxes and the horizon blur with it. Linear light; may exceed 1.
glm::vec3 studio_light(const SceneStudio& studio, glm::vec3 from, float roughness);

}  // namespace verdigris
