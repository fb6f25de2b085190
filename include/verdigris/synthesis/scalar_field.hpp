#pragma once
// A scalar field in space: points in, scalars out, many at a time.

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace verdigris {

/// Points as a structure of arrays, [point]. Coordinates left empty are 0 everywhere; those given are as
/// long as x.
struct Points {
  std::span<const double> x, y = {}, z = {}, w = {};

  std::size_t size() const { return x.size(); }
};

/// Between what a field's values lie.
struct ValueRange {
  float least = 0.0f, greatest = 1.0f;
  bool sure = true;  ///< no value lies outside; otherwise hardly one does, and who needs bounds must clamp
};

/// An axis-parallel box, in the units of a field's points.
struct Window {
  glm::dvec3 lower{0.0}, upper{1.0};
};

/// A function of points, frozen when it is made: the same values in any order, from any number of threads,
/// in batches of any size, to the bit.
class ScalarField {
 public:
  virtual ~ScalarField() = default;

  /// out[k] = value at point k. `footprint` is the distance between neighbouring samples, in the units of
  /// the points: detail finer than two footprints fades out, so that it cannot alias; 0 keeps all of it.
  /// Throws std::invalid_argument when `out` or a coordinate is not as long as x.
  void evaluate(const Points& points, double footprint, std::span<float> out) const;

  /// The value at one point. Slow: for tests and a handful of points.
  float at(const glm::dvec4& point, double footprint = 0.0) const;

  virtual ValueRange range() const = 0;

  /// The part of space worth looking at: what a picture shows, what a model is laid into. Fields without
  /// end show the unit box.
  virtual Window window() const { return {}; }

 private:
  /// As evaluate, with sizes checked.
  virtual void compute(const Points& points, double footprint, std::span<float> out) const = 0;
};

}  // namespace verdigris
