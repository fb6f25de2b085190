#pragma once
// Where a picture is taken from: a named view or a direction, framed so that the model fills the image.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// The axis of the model that points up.
enum class UpAxis : std::uint8_t { y, z };

/// A perspective camera. Its axes are orthonormal: right, up, backward (from the model to the eye).
class Camera {
 public:
  glm::dvec3 eye{0.0, 0.0, 1.0};   ///< model space
  double tangent = 0.268;          ///< tan of half the vertical opening angle
  double near = 0.1, far = 10.0;   ///< distances from the eye, model units
  int width = 1280, height = 960;  ///< pixels

  Camera() = default;
  /// Axes from the direction towards the eye and an up hint, which must not be parallel.
  Camera(glm::dvec3 backward, glm::dvec3 up_hint);

  glm::dvec3 right() const { return right_; }
  glm::dvec3 up() const { return up_; }
  glm::dvec3 backward() const { return backward_; }

  /// Clip coordinates of points given relative to `origin` (double until here, so large offsets lose
  /// nothing).
  glm::mat4 clip_from_model(glm::dvec3 origin = glm::dvec3(0.0)) const;
  /// Pixel coordinates (from the top left corner) and depth in 0..1 of a point.
  glm::dvec3 to_pixel(glm::dvec3 point) const;

 private:
  glm::dvec3 right_{1.0, 0.0, 0.0}, up_{0.0, 1.0, 0.0}, backward_{0.0, 0.0, 1.0};
};

/// What to see and how large.
struct ViewSettings {
  UpAxis up = UpAxis::y;
  double field_of_view = 30.0;  ///< degrees, of the longer side of the image
  double margin = 0.04;         ///< share of the image left free on each side that the model reaches
  int width = 1280, height = 960;
};

/// Unit direction from the model to the eye: front, back, left, right, top, bottom, iso, or "x,y,z". With y
/// up the front is seen from +z, with z up from -y; right is +x. Throws InputError for anything else.
glm::dvec3 view_direction(std::string_view view, UpAxis up = UpAxis::y);

/// The camera that looks along -`direction` and stands as near as the whole mesh allows: the frame touches
/// the projected vertices themselves, not a bounding sphere. Throws InputError for an image size that is not
/// positive or a field of view outside (0, 180).
Camera frame_mesh(const Mesh& mesh, glm::dvec3 direction, const ViewSettings& settings = {});
Camera frame_mesh(const Mesh& mesh, std::string_view view, const ViewSettings& settings = {});

}  // namespace verdigris
