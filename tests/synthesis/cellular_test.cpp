// Cellular noise: distances as of all points, whichever the metric.

#include <gtest/gtest.h>

#include <algorithm>

#include "samples.hpp"
#include "verdigris/synthesis/cellular_noise.hpp"

namespace verdigris {
namespace {

std::vector<float> values(const PointList& points, const std::string& distance, const std::string& metric,
                          int dimensions, double jitter = 1.0) {
  return values_of(*CellularNoise{.distance = distance,
                                  .metric = metric,
                                  .dimensions = dimensions,
                                  .frequency = 1.0,
                                  .jitter = jitter}
                        .make(4),
                   points);
}

TEST(Cellular, DistancesHaveNoJumps) {
  // F1 and F2 grow no faster than one walks (times sqrt d for manhattan): a point missed by the search would
  // make them jump.
  for (const int dimensions : {2, 3})
    for (const char* metric : {"euclidean", "manhattan", "chebyshev"})
      for (const char* distance : {"F1", "F2"}) {
        PointList line;
        const double step = 0.002;
        for (int k = 0; k < 200000; ++k) line.add(0.6 * step * k, 0.8 * step * k);
        const auto v = values(line, distance, metric, dimensions);
        const float most = static_cast<float>(step) * (metric[0] == 'm'   ? 1.4f
                                                       : metric[0] == 'c' ? 0.8f
                                                                          : 1.0f);
        for (std::size_t k = 1; k < v.size(); ++k)
          ASSERT_LE(std::fabs(v[k] - v[k - 1]), most + 2e-6f)
              << metric << " " << distance << " " << dimensions;
      }
}

TEST(Cellular, WithoutJitterItIsAGrid) {
  // F1 in a square lattice: mean distance to the centre of a unit square, (sqrt 2 + asinh 1) / 6.
  const auto f1 = values(scattered(1 << 18, 1000.0), "F1", "euclidean", 2, 0.0);
  EXPECT_NEAR(moments(f1).mean, (std::sqrt(2.0) + std::asinh(1.0)) / 6.0, 0.001);
  EXPECT_LE(*std::max_element(f1.begin(), f1.end()), std::sqrt(0.5f) + 1e-6f);
}

TEST(Cellular, DifferencesAreOfTheTwo) {
  const PointList points = scattered(10000, 1000.0);
  for (const int dimensions : {2, 3}) {
    const auto f1 = values(points, "F1", "euclidean", dimensions),
               f2 = values(points, "F2", "euclidean", dimensions),
               difference = values(points, "F2-F1", "euclidean", dimensions);
    for (std::size_t k = 0; k < f1.size(); ++k) {
      ASSERT_EQ(difference[k], f2[k] - f1[k]);
      ASSERT_GE(difference[k], 0.0f);
    }
  }
}

TEST(Cellular, MetricsAreOrdered) {
  const PointList points = scattered(10000, 1000.0);
  const auto most = values(points, "F1", "chebyshev", 3), euclidean = values(points, "F1", "euclidean", 3),
             sum = values(points, "F1", "manhattan", 3);
  for (std::size_t k = 0; k < most.size(); ++k) {
    ASSERT_LE(most[k], euclidean[k] + 1e-6f);
    ASSERT_LE(euclidean[k], sum[k] + 1e-6f);
  }
}

}  // namespace
}  // namespace verdigris
