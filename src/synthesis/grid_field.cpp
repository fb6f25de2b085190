#include "grid_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace verdigris::synthesis {

namespace {

// Index of a point that may lie outside, among `count` of which the last may repeat the first. Negative:
// beyond the border.
int inside(int k, int count, Beyond beyond) {
  if (count == 1) return 0;
  const int period = beyond == Beyond::repeat ? count - 1 : 2 * (count - 1);
  if (beyond == Beyond::zero) return k >= 0 && k < count ? k : -1;
  k %= period;
  if (k < 0) k += period;
  return k < count ? k : period - k;
}

// Weights of the four points about `t`, 0 to 1 between the second and the third (Catmull & Rom 1974).
void spline_weights(double t, double (&w)[4]) {
  w[0] = t * (-0.5 + t * (1.0 - 0.5 * t));
  w[1] = 1.0 + t * t * (-2.5 + 1.5 * t);
  w[2] = t * (0.5 + t * (2.0 - 1.5 * t));
  w[3] = t * t * (-0.5 + 0.5 * t);
}

// Far out, indices would not fit: whole periods are taken off first.
double folded(double x, Beyond beyond) {
  if (!std::isfinite(x)) return beyond == Beyond::zero ? -1.0 : 0.0;
  return beyond == Beyond::zero ? std::clamp(x, -1.0, 2.0) : x - 2.0 * std::floor(0.5 * x);
}

}  // namespace

GridField::GridField(std::vector<float> values, int columns, int rows, Beyond beyond, const Window& window)
    : beyond_(beyond), window_(window) {
  levels_.push_back({std::move(values), columns, rows});
  while (levels_.back().columns % 2 == 1 && levels_.back().columns > 3 &&
         (rows == 1 || (levels_.back().rows % 2 == 1 && levels_.back().rows > 3)))
    levels_.push_back(half(levels_.back()));
}

// Every second point, each the mean of its surroundings with weights 1 2 1 along both axes.
GridField::Level GridField::half(const Level& level) const {
  Level coarse{{}, (level.columns + 1) / 2, (level.rows + 1) / 2};
  coarse.values.reserve(static_cast<std::size_t>(coarse.columns) * static_cast<std::size_t>(coarse.rows));
  const auto at = [&](int column, int row) {
    column = inside(column, level.columns, beyond_);
    row = inside(row, level.rows, beyond_);
    if (column < 0 || row < 0) return 0.0f;
    return level.values[static_cast<std::size_t>(row) * static_cast<std::size_t>(level.columns) +
                        static_cast<std::size_t>(column)];
  };
  for (int row = 0; row < coarse.rows; ++row)
    for (int column = 0; column < coarse.columns; ++column) {
      const auto along = [&](int r) {
        return 0.25f * at(2 * column - 1, r) + 0.5f * at(2 * column, r) + 0.25f * at(2 * column + 1, r);
      };
      coarse.values.push_back(level.rows == 1 ? along(0)
                                              : 0.25f * along(2 * row - 1) + 0.5f * along(2 * row) +
                                                    0.25f * along(2 * row + 1));
    }
  return coarse;
}

double GridField::sample(const Level& level, double x, double y) const {
  x *= level.columns - 1;
  y *= level.rows - 1;
  const double column = std::floor(x), row = std::floor(y);
  double wx[4], wy[4];
  spline_weights(x - column, wx);
  spline_weights(y - row, wy);
  int columns[4];
  for (int i = 0; i < 4; ++i) columns[i] = inside(static_cast<int>(column) - 1 + i, level.columns, beyond_);
  double sum = 0.0;
  for (int j = 0; j < 4; ++j) {
    const int r = inside(static_cast<int>(row) - 1 + j, level.rows, beyond_);
    if (r < 0 || wy[j] == 0.0) continue;
    const float* values =
        level.values.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(level.columns);
    double along = 0.0;
    for (int i = 0; i < 4; ++i)
      if (columns[i] >= 0) along += wx[i] * static_cast<double>(values[columns[i]]);
    sum += wy[j] * along;
  }
  return sum;
}

void GridField::compute(const Points& points, double footprint, std::span<float> out) const {
  const glm::dvec3 extent = window_.upper - window_.lower;
  const bool flat = levels_[0].rows == 1;
  // A grid holds waves down to two of its spacings: it serves footprints up to its spacing.
  const double spacing = extent.x / (levels_[0].columns - 1);
  const double detail = std::clamp(footprint > spacing ? std::log2(footprint / spacing) : 0.0, 0.0,
                                   static_cast<double>(levels_.size() - 1));
  const auto fine = static_cast<std::size_t>(detail);
  const double blend = detail - static_cast<double>(fine);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double x = folded((points.x[k] - window_.lower.x) / extent.x, beyond_);
    const double y =
        flat || points.y.empty() ? 0.0 : folded((points.y[k] - window_.lower.y) / extent.y, beyond_);
    double value = sample(levels_[fine], x, y);
    if (blend > 0.0) value += blend * (sample(levels_[fine + 1], x, y) - value);
    out[k] = static_cast<float>(std::clamp(value, 0.0, 1.0));
  }
}

std::vector<float> to_unit_range(const std::vector<double>& values) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double low = *least, extent = *greatest - *least;
  std::vector<float> unit(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    unit[k] = extent > 0.0 ? static_cast<float>((values[k] - low) / extent) : 0.5f;
  return unit;
}

}  // namespace verdigris::synthesis
