#include "verdigris/synthesis/scalar_field.hpp"

#include <stdexcept>

namespace verdigris {

void ScalarField::evaluate(const Points& points, double footprint, std::span<float> out) const {
  const std::size_t size = points.size();
  const auto fits = [&](std::span<const double> axis) { return axis.empty() || axis.size() == size; };
  if (out.size() != size || !fits(points.y) || !fits(points.z) || !fits(points.w))
    throw std::invalid_argument("coordinates and values of a scalar field must be of one length");
  if (size != 0) compute(points, footprint, out);
}

float ScalarField::at(const glm::dvec4& point, double footprint) const {
  float value = 0.0f;
  evaluate({{&point.x, 1}, {&point.y, 1}, {&point.z, 1}, {&point.w, 1}}, footprint, {&value, 1});
  return value;
}

}  // namespace verdigris
