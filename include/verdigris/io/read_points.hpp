#pragma once
// Small text inputs: points, indices and numbers, one a line.

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

namespace verdigris {

/// A point of a seed file, and the weight that may follow it.
struct WeightedPoint {
  glm::dvec3 position;
  double weight = 1.0;
};

/// Reads `x y z` or `x y z weight` a line (blanks, commas or tabs between; `#` begins a comment). Throws
/// InputError with file and line for anything else, for numbers that are not finite, and for a file without
/// points.
std::vector<WeightedPoint> read_points(const std::filesystem::path& file);

/// Reads one number a line; as strict.
std::vector<double> read_numbers(const std::filesystem::path& file);

}  // namespace verdigris
