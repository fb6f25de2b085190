#pragma once
// The part of a scene that makes a film of it.

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace verdigris {

/// A view that the camera passes.
struct CameraPlan {
  double at = 0.0;                   ///< 0..1 of the film
  std::string view;                  ///< as PicturePlan::view
  double zoom = 1.0;                 ///< 2: from half the distance
  std::optional<glm::dvec3> target;  ///< in the middle of the picture; none: the middle of the model
  friend bool operator==(const CameraPlan&, const CameraPlan&) = default;
};

/// Table [animation] of a scene.
struct AnimationPlan {
  std::uint64_t frames = 120;      ///< when no years are chosen
  std::vector<double> years;       ///< chosen times, a frame each; empty: spread over the run
  double rate = 24.0;              ///< frames a second
  std::uint64_t hold = 12;         ///< frames that a still stands: beginning, end, and what takes no time
  double turn = 0.0;               ///< degrees that the camera goes round the model
  std::vector<CameraPlan> camera;  ///< views on its way; empty: that of the picture
  bool overlay = false;            ///< write time and curve over the frames
  friend bool operator==(const AnimationPlan&, const AnimationPlan&) = default;
};

}  // namespace verdigris
