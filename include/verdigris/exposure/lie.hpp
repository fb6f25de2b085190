#pragma once
// How places lie in the world: how high, how steep, facing where.

#include <glm/vec3.hpp>
#include <string_view>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Unit normals at cells: those of the corners interpolated, smooth over edges whose faces turn by up to
/// `crease_angle` degrees. Computed once for many cells; refers to the surface, which must outlive it.
class CellNormals {
 public:
  explicit CellNormals(const Surface& surface, double crease_angle = 40.0);
  glm::dvec3 at(std::size_t patch, glm::dvec2 point) const;

 private:
  const Surface& surface_;
  std::vector<glm::dvec3> corners_;  // [3 * triangle + corner]
};

/// Height along `up`, [slot] 0 at the lowest point of the model, 1 at the highest; 0 everywhere on a model of
/// no height. Directions here are of any length; InputError if it is 0.
Field<float> height_mask(const Surface& surface, glm::dvec3 up);

/// Height along `up` from the origin, [slot] model units.
Field<float> height_above_origin(const Surface& surface, glm::dvec3 up);

/// Slope, [slot]: the angle between normal and `up` in right angles: 0 level ground, 1 a wall, 2 a ceiling.
Field<float> slope_mask(const Surface& surface, glm::dvec3 up);

/// How squarely places face `towards` (the sky, the wind's origin, the sun), [slot]: cosine^sharpness, 0
/// where turned away. sharpness > 0.
Field<float> facing_mask(const Surface& surface, glm::dvec3 towards, double sharpness = 1.0);

/// Three numbers separated by commas or blanks, or up to sign an axis: "0 1 0.5", "x", "-y". Throws
/// InputError naming `where` for anything else and for a direction without length.
glm::dvec3 parse_direction(std::string_view text, std::string_view where);

}  // namespace verdigris
