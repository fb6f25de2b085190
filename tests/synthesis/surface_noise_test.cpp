// Noise on a surface: both sides of an edge give it the same values.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/common.hpp>
#include <map>

#include "samples.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/surface/frame.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

// Points of every edge shared by two triangles, as either triangle's frame places them.
void points_of_edges(const Mesh& mesh, PointList& one_side, PointList& other_side) {
  glm::dvec3 lower = mesh.positions[0], upper = lower;
  for (const glm::dvec3& p : mesh.positions) lower = glm::min(lower, p), upper = glm::max(upper, p);
  const glm::dvec3 extent = upper - lower;
  const double size = std::max({extent.x, extent.y, extent.z});
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<Frame, int>> first;
  for (const auto& t : mesh.triangles) {
    const Frame frame = make_frame(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
    for (int k = 0; k < 3; ++k) {
      const auto from = t[static_cast<std::size_t>((frame.first_corner + k) % 3)],
                 to = t[static_cast<std::size_t>((frame.first_corner + k + 1) % 3)];
      const auto found = first.find({to, from});
      if (found == first.end()) {
        first.insert({{from, to}, {frame, k}});
        continue;
      }
      const auto& [over, edge] = found->second;
      for (const double s : {0.0, 0.137, 0.5, 0.731}) {
        const auto place = [&](const Frame& f, int e, double at) {
          return (f.to_model((1.0 - at) * f.corner(e) + at * f.corner((e + 1) % 3)) - lower) / size;
        };
        const glm::dvec3 a = place(frame, k, s), b = place(over, edge, 1.0 - s);
        one_side.add(a.x, a.y, a.z);
        other_side.add(b.x, b.y, b.z);
      }
    }
  }
}

void expect_no_seam(const std::filesystem::path& file) {
  PointList one_side, other_side;
  points_of_edges(read_mesh(file), one_side, other_side);
  ASSERT_GT(one_side.size(), 0u);
  double apart = 0.0;
  for (std::size_t k = 0; k < one_side.size(); ++k)
    apart = std::max(apart, std::hypot(one_side.x[k] - other_side.x[k], one_side.y[k] - other_side.y[k],
                                       one_side.z[k] - other_side.z[k]));
  std::printf("  the sides place their points up to %.2g apart\n", apart);
  EXPECT_GT(apart, 0.0);
  const PrimitiveCatalogue catalogue = builtin_primitives();
  const auto compare = [&](const std::string& name, const ParameterValues& parameters) {
    const auto field = catalogue.find(name).create(parameters, 7);
    const auto a = values_of(*field, one_side), b = values_of(*field, other_side);
    double worst = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
      worst = std::max(worst, std::fabs(static_cast<double>(a[k]) - static_cast<double>(b[k])));
    std::printf("  %-16s %.2g over %zu points\n", name.c_str(), worst, a.size());
    EXPECT_LE(worst, 1e-6) << name;
  };
  for (const char* name : {"gradient", "value", "cellular", "multiresolution", "fbm", "turbulence", "ridged",
                           "multifractal", "hybrid", "warp"})
    compare(name, {});
  // The finest that eight octaves reach here: 14,000 cells along the model.
  compare("fbm", {{"frequency", 100.0}, {"h", 0.0}});
  compare("cellular", {{"frequency", 10000.0}, {"distance", "F2-F1"}});
}

TEST(SurfaceNoise, HasNoSeamAtTheEdgesOfTheBunny) {
  const std::filesystem::path file = std::filesystem::path(VERDIGRIS_SHARED_MESHES) / "stanford-bunny.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  expect_no_seam(file);
}

TEST(SurfaceNoise, HasNoSeamAtTheEdgesOfTheCup) {
  expect_no_seam(std::filesystem::path(VERDIGRIS_MESHES) / "cup.obj");
}

}  // namespace
}  // namespace verdigris
