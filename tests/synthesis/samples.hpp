#pragma once
// Points to look at fields at, and what is asked of the values.

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris {

/// Points as arrays of their own.
struct PointList {
  std::vector<double> x, y, z, w;

  void add(double px, double py, double pz = 0.0, double pw = 0.0) {
    x.push_back(px), y.push_back(py), z.push_back(pz), w.push_back(pw);
  }
  std::size_t size() const { return x.size(); }
  operator Points() const { return {x, y, z, w}; }  // NOLINT: the same thing
};

/// `count` points at random in [0, extent)^4.
inline PointList scattered(std::size_t count, double extent, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const auto next = [&] { return extent * static_cast<double>(random()) * 0x1p-32; };
  PointList points;
  for (std::size_t k = 0; k < count; ++k) {
    const double px = next(), py = next(), pz = next();
    points.add(px, py, pz, next());
  }
  return points;
}

/// side x side points of the unit square, rows along x, at height z.
inline PointList unit_grid(std::size_t side, double z = 0.0) {
  PointList points;
  const double step = 1.0 / static_cast<double>(side);
  for (std::size_t k = 0; k < side * side; ++k)
    points.add(step * static_cast<double>(k % side), step * static_cast<double>(k / side), z);
  return points;
}

inline std::vector<float> values_of(const ScalarField& field, const PointList& points,
                                    double footprint = 0.0) {
  std::vector<float> values(points.size());
  field.evaluate(points, footprint, values);
  return values;
}

struct Moments {
  double mean = 0.0, variance = 0.0;
};
inline Moments moments(const std::vector<float>& values) {
  Moments m;
  for (const float v : values) m.mean += static_cast<double>(v);
  m.mean /= static_cast<double>(values.size());
  for (const float v : values) m.variance += std::pow(static_cast<double>(v) - m.mean, 2.0);
  m.variance /= static_cast<double>(values.size());
  return m;
}

/// Pearson's coefficient.
inline double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double sa = 0, sb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sa += a[k], sb += b[k];
    aa += a[k] * a[k], bb += b[k] * b[k], ab += a[k] * b[k];
  }
  return (n * ab - sa * sb) / std::sqrt((n * aa - sa * sa) * (n * bb - sb * sb));
}

}  // namespace verdigris
