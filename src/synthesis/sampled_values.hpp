#pragma once
// What is known of a field only by looking.

#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris::synthesis {

/// `count` values of a field at points spread over as many features of size `cell`. Always the same ones.
std::vector<float> sampled_values(const ScalarField& field, double cell, std::size_t count);

/// Between what all but one in a thousand values lie, at either end; not sure, but always the same.
ValueRange sampled_range(const ScalarField& field, double cell);

/// The mean over shape(value).
template <typename Shape>
float sampled_mean(const ScalarField& field, double cell, Shape&& shape) {
  double sum = 0.0;
  const std::vector<float> values = sampled_values(field, cell, 32768);
  for (const float value : values) sum += static_cast<double>(shape(value));
  return static_cast<float>(sum / static_cast<double>(values.size()));
}

}  // namespace verdigris::synthesis
