// Mesh independence: one square sheet, triangulated five ways, corrodes alike.

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <set>

#include "corrosion.hpp"

using namespace growth;

namespace {

constexpr double side = 300.0;

// A square of `side` cells in a jittered grid of about `spacing`, diagonals at random; the rim stays
// straight.
Mesh random_sheet(double spacing, unsigned seed) {
  std::mt19937 engine(seed);
  const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0 - 0.5; };
  const int n = static_cast<int>(side / spacing);
  const double step = side / n;
  Mesh m = shapes::grid(n, n, false, false, [&](int i, int j) {
    const double dx = 0.5 * uniform() * (i > 0 && i < n), dy = 0.5 * uniform() * (j > 0 && j < n);
    return glm::dvec3((i + dx) * step, (j + dy) * step, 0.0);
  });
  shapes::flip_diagonals(m, engine);
  return m;
}

Mesh regular_sheet(int n) {
  return shapes::grid(n, n, false, false,
                      [&](int i, int j) { return glm::dvec3(i * side / n, j * side / n, 0.0); });
}

// Mean share corroded at each step over 20 runs, from four given seeds and new ones.
std::vector<double> mean_curve(const Mesh& mesh, std::size_t given) {
  const Surface s = make_surface(mesh, {.cell_size = 1.0});
  std::vector<double> mean;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SimulationSetup setup{s, seed};
    // The same places on every sheet.
    std::set<std::uint32_t> taken;
    for (std::uint32_t k = 0; k < given; ++k) {
      const auto word = CellRandom(seed, 0, k).words(77);
      const std::uint32_t slot =
          slot_at(s, {side * (word[0] / 4294967296.0), side * (word[1] / 4294967296.0), 0.0});
      if (taken.insert(slot).second) setup.seeds.push_back({slot, 1.0});
    }
    CorrosionParameters p;
    p.new_seeds = given > 0 ? 0.0 : 1e-6;
    p.most_seeds = 12;
    CorrosionGrowth growth(setup, p);
    std::uint64_t cells = 0;
    for (std::size_t step = 0; step < 3000; ++step) {
      if (mean.size() <= step) mean.resize(step + 1, 0.0);
      if (!growth.finished()) cells += growth.step().changed;
      mean[step] +=
          static_cast<double>(cells + setup.seeds.size()) / static_cast<double>(s.owned_count()) / 20.0;
    }
  }
  return mean;
}

double step_of(const std::vector<double>& curve, double share) {
  const auto at = std::lower_bound(curve.begin(), curve.end(), share);
  const auto k = static_cast<double>(at - curve.begin());
  return at == curve.begin() || at == curve.end() ? k : k - (*at - share) / (*at - at[-1]);
}

TEST(LongCorrosionSheet, CorrodesAlikeHoweverItIsTriangulated) {
  const std::pair<const char*, Mesh> sheets[] = {{"2 triangles", shapes::square(side)},
                                                 {"regular", regular_sheet(12)},
                                                 {"random, 50 cells", random_sheet(50, 1)},
                                                 {"random, 25 cells", random_sheet(25, 2)},
                                                 {"random, 10 cells", random_sheet(10, 3)}};
  for (const std::size_t given : {std::size_t{8}, std::size_t{0}}) {
    std::vector<std::vector<double>> curves;
    double half = 0.0, least = 1e9, most = 0.0;
    for (const auto& [name, mesh] : sheets) {
      curves.push_back(mean_curve(mesh, given));
      const double step = step_of(curves.back(), 0.5);
      EXPECT_GT(curves.back().back(), 0.9999) << name;
      std::printf("%zu given seeds, %-17s steps to 10 %%, 50 %%, 90 %%: %6.1f %6.1f %6.1f\n", given, name,
                  step_of(curves.back(), 0.1), step, step_of(curves.back(), 0.9));
      half += step / 5.0;
      least = std::min(least, step);
      most = std::max(most, step);
    }
    EXPECT_LT(most - least, 0.05 * half) << given;
    // And the shares themselves at the mean time of half saturation.
    double lowest = 1.0, highest = 0.0;
    for (const auto& curve : curves) {
      lowest = std::min(lowest, curve[static_cast<std::size_t>(half)]);
      highest = std::max(highest, curve[static_cast<std::size_t>(half)]);
    }
    std::printf("%zu given seeds, shares at step %.0f: %.4f to %.4f\n", given, half, lowest, highest);
    EXPECT_LT(highest - lowest, 0.05) << given;
  }
}

}  // namespace
