// The same bits with and without vector instructions, in batches of any size, from any number of threads.

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "field_digest.hpp"
#include "samples.hpp"

namespace verdigris {
namespace {

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string text;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, count);
  return pclose(pipe) == 0 ? text : "";
}

TEST(NoiseBits, AreThoseOfAProgramWithoutVectorInstructions) {
  const std::string plain = output_of(VERDIGRIS_PLAIN_DIGESTS);
  ASSERT_FALSE(plain.empty()) << VERDIGRIS_PLAIN_DIGESTS;
  EXPECT_EQ(field_digests(), plain);
}

TEST(NoiseBits, DoNotDependOnBatchesOrThreads) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  const PointList points = scattered(5000, 1.0);
  for (const PrimitiveEntry& entry : catalogue.entries()) {
    const auto field = entry.create({}, 11);
    const auto whole = values_of(*field, points, 0.001);
    for (const std::size_t threads : {1, 4}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      std::vector<float> parts(points.size());
      tbb::parallel_for(std::size_t{0}, (points.size() + 36) / 37, [&](std::size_t part) {
        const std::size_t first = part * 37, count = std::min<std::size_t>(37, points.size() - first);
        const auto piece = [&](const std::vector<double>& axis) {
          return std::span<const double>(axis).subspan(first, count);
        };
        field->evaluate({piece(points.x), piece(points.y), piece(points.z), piece(points.w)}, 0.001,
                        std::span<float>(parts).subspan(first, count));
      });
      EXPECT_EQ(parts, whole) << entry.name << ", " << threads << " threads";
    }
    for (const std::size_t k : {0, 63, 4999})
      EXPECT_EQ(field->at({points.x[k], points.y[k], points.z[k], points.w[k]}, 0.001), whole[k])
          << entry.name;
  }
}

TEST(NoiseBits, AreNumbersWhateverThePoints) {
  const double odd[] = {0.0,
                        -0.0,
                        1e-300,
                        -1e-17,
                        1e9,
                        -1e15,
                        1e300,
                        std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN()};
  const PrimitiveCatalogue catalogue = builtin_primitives();
  // Fields that look up a grid fold the plane into it.
  const std::pair<const char*, ParameterValues> grids[] = {
      {"diamond-square", {}},
      {"barnsley-fern", {}},
      {"sierpinski-triangle", {{"measure", std::string("density")}}}};
  for (const auto& [name, values] : grids) {
    const auto field = catalogue.find(name).create(values, 1);
    for (const double x : odd)
      for (const double y : odd)
        EXPECT_TRUE(std::isfinite(field->at({x, y, 0.5, 0.5}))) << name << " " << x << " " << y;
  }
  for (const char* name :
       {"gradient", "value", "cellular", "fbm", "turbulence", "ridged", "multifractal", "hybrid", "warp"})
    for (const double period : {0.0, 1.0}) {
      const auto field = catalogue.find(name).create({{"period", period}}, 1);
      for (const double x : odd)
        for (const double y : odd)
          EXPECT_TRUE(std::isfinite(field->at({x, y, 0.5, 0.5}))) << name << " " << x << " " << y;
    }
}

TEST(NoiseBits, SeedsGiveDifferentNoise) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  const PointList points = scattered(4096, 100.0);
  for (const char* name : {"gradient", "value", "cellular", "fbm", "hybrid", "warp"}) {
    const auto& entry = catalogue.find(name);
    const auto one = values_of(*entry.create({}, 1), points), other = values_of(*entry.create({}, 2), points);
    EXPECT_EQ(values_of(*entry.create({}, 1), points), one);
    EXPECT_LT(std::fabs(correlation({one.begin(), one.end()}, {other.begin(), other.end()})), 0.06) << name;
  }
}

}  // namespace
}  // namespace verdigris
