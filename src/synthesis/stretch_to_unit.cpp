#include "verdigris/synthesis/stretch_to_unit.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace verdigris {

void stretch_to_unit(std::span<float> values, double low, double high) {
  const auto from = static_cast<float>(low);
  const auto factor = static_cast<float>(1.0 / (high - low));
  if (!std::isfinite(from) || !std::isfinite(factor) || !std::isfinite(high))
    throw std::invalid_argument("a stretch of no width, or of none that a float can hold");
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, values.size(), 65536), [&](const auto& range) {
    for (std::size_t k = range.begin(); k < range.end(); ++k)
      values[k] = std::clamp((values[k] - from) * factor, 0.0f, 1.0f);
  });
}

}  // namespace verdigris
