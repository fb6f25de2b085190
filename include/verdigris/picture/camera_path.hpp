#pragma once
// A camera that moves: round the model as on a turntable, or from view to view.

#include <optional>
#include <vector>

#include "verdigris/picture/camera.hpp"

namespace verdigris {

/// A view on the way.
struct CameraKey {
  double at = 0.0;                   ///< when, 0..1 of the film
  glm::dvec3 direction{0, 0, 1};     ///< from the model to the eye, any length
  double zoom = 1.0;                 ///< 2: from half the distance
  std::optional<glm::dvec3> target;  ///< what is in the middle, model units; none: the middle of the model
};

/// A way from key to key that never jerks: heading, elevation, distance and target follow monotone cubics
/// (Fritsch and Carlson 1980), the heading the shorter way round. On top of it the model turns by `turn`
/// degrees, evenly over the film. Of one key and no turn the camera is that of frame_mesh; else it keeps one
/// distance (over the zoom), from which the whole model is in the picture at all times.
class CameraPath {
 public:
  /// Keys ascend in `at`. Throws InputError for none, two at one time, zooms that are not positive, and what
  /// frame_mesh refuses.
  CameraPath(const Mesh& mesh, std::vector<CameraKey> keys, double turn, const ViewSettings& settings);

  /// The camera at a share of the film, 0..1.
  Camera at(double share) const;
  /// Whether it is not the same all the time.
  bool moves() const { return turn_ != 0.0 || poses_.size() > 1; }

 private:
  struct Pose {
    double heading, elevation, nearness;  // radians, radians, logarithm of the zoom
    glm::dvec3 target;
  };
  Pose pose_at(double share) const;
  std::vector<glm::dvec3> directions_on_the_way() const;
  glm::dvec3 direction_of(const Pose& pose) const;
  Camera turned_to(glm::dvec3 direction) const;

  std::vector<double> times_;
  std::vector<Pose> poses_;
  double turn_;
  ViewSettings settings_;
  double distance_ = 0.0, radius_ = 0.0;
  glm::dvec3 middle_;
  Camera still_;         // of the first view, as frame_mesh makes it
  bool framed_ = false;  // it stays that
};

}  // namespace verdigris
