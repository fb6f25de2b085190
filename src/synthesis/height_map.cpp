#include "verdigris/synthesis/height_map.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>

namespace verdigris {

HeightMap sample_heights(const ScalarField& field, int width, int height, double section) {
  if (width < 1 || height < 1) throw std::invalid_argument("a height map without samples");
  const Window window = field.window();
  const glm::dvec3 extent = window.upper - window.lower;
  const auto across = static_cast<std::size_t>(width), down = static_cast<std::size_t>(height);
  HeightMap map{width, height, std::max(extent.x / width, extent.y / height), {}};
  map.values.resize(across * down);
  // Middle of the window, less half of what is shown.
  const double left = 0.5 * (window.lower.x + window.upper.x - map.step * width);
  const double top = 0.5 * (window.lower.y + window.upper.y + map.step * height);
  std::vector<double> x(across);
  for (std::size_t k = 0; k < across; ++k) x[k] = left + map.step * (static_cast<double>(k) + 0.5);
  tbb::parallel_for(std::size_t{0}, down, [&](std::size_t row) {
    const std::vector<double> y(across, top - map.step * (static_cast<double>(row) + 0.5)),
        z(across, section);
    field.evaluate({x, y, z}, map.step, std::span(map.values).subspan(row * across, across));
  });
  return map;
}

}  // namespace verdigris
