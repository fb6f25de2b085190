// The numbers of corrosion against sums over its cells.

#include "verdigris/behaviours/corrosion_statistics.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "corrosion.hpp"
#include "verdigris/behaviours/corrosion_layers.hpp"
#include "verdigris/io/read_material.hpp"
#include "verdigris/io/write_corrosion.hpp"

using namespace growth;

namespace {

TEST(CorrosionStatistics, MassLossIsTheSumOverCells) {
  const Surface s = make_surface(shapes::torus(3, 1, 20, 12), {.cell_size = 0.05});
  const Material zinc = find_material("zinc");
  constexpr double step_years = 0.3;
  for (const bool rates : {false, true})
    for (const bool material : {false, true}) {
      SimulationSetup setup{s, 3};
      if (rates) {
        setup.masks.push_back({"rate", Field<float>(s.slot_count())});
        each_owned(s, [&](std::uint32_t slot) {
          setup.masks[0].values[slot] = static_cast<float>(0.5 + 0.4 * s.position(slot).z);
        });
      }
      CorrosionParameters p;
      p.new_seeds = 1e-4;
      p.thickness.metal = 20.0;
      p.thickness.k1 = 0.25;
      CorrosionGrowth growth(setup, p);
      CorrosionStatistics statistics(material ? scale_of(zinc, ExposureClass::CX, step_years)
                                              : scale_of(growth, step_years, 7.14));
      std::uint64_t corroded = 0;
      for (int step = 1; step <= 150; ++step) {
        corroded += growth.step().changed;
        const CorrosionNumbers numbers = statistics.measure(growth);
        ASSERT_EQ(numbers.corroded, corroded);
        if (step % 30 != 0) continue;
        const auto age = growth.ages(), state = growth.field("state");
        const auto depth = growth.real_field("depth");
        double sum = 0.0, most = 0.0, gone = 0.0;
        each_owned(s, [&](std::uint32_t slot) {
          if (age[slot] < 0) return;
          const double rate = rates ? growth.rates()[slot] / 255.0 : 1.0;
          const double d =
              material ? metal_loss(zinc, ExposureClass::CX, age[slot] * step_years, rate) : depth[slot];
          sum += d;
          most = std::max(most, d);
          gone += material ? d >= zinc.thickness : state[slot] == 2;
        });
        const auto cells = static_cast<double>(s.owned_count());
        ASSERT_GT(sum, 0.0);
        // Grams: micrometres x area of a cell x density; over the area of all cells.
        EXPECT_NEAR(numbers.mass_loss, sum * 7.14 / cells, 1e-5 * numbers.mass_loss);
        EXPECT_NEAR(numbers.mean_depth, sum / cells, 1e-5 * numbers.mean_depth);
        EXPECT_NEAR(numbers.mean_depth_corroded, sum / static_cast<double>(corroded), 1e-4);
        EXPECT_NEAR(numbers.greatest_depth, most, 1e-4);
        EXPECT_EQ(static_cast<double>(numbers.gone), gone);
        EXPECT_EQ(numbers.share, static_cast<double>(corroded) / cells);
        EXPECT_DOUBLE_EQ(numbers.years, step * step_years);
      }
      EXPECT_GT(corroded, 1000u);
    }
}

TEST(CorrosionLayers, AreTheStackAtEachCellsAge) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.02});
  const Material steel = find_material("steel");
  for (const bool rates : {false, true}) {
    SimulationSetup setup{s, 3, random_seeds(s, 5, 2)};
    if (rates) setup.masks.push_back({"rate", Field<float>(s.slot_count(), 0.6f)});
    CorrosionGrowth growth(setup, {});
    for (int step = 0; step < 120; ++step) growth.step();
    const auto fields = corrosion_layers(growth, steel, ExposureClass::C4, 0.1);
    const auto age = growth.ages();
    ASSERT_EQ(fields.layers.size(), 3u);
    each_owned(s, [&](std::uint32_t slot) {
      const Stack stack =
          stack_at(steel, ExposureClass::C4, age[slot] < 0 ? -1.0 : 0.1 * age[slot], rates ? 0.6 : 1.0);
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_FLOAT_EQ(fields.layers[k][slot], static_cast<float>(stack.layers[k]));
      ASSERT_FLOAT_EQ(fields.metal_lost[slot], static_cast<float>(stack.metal_lost));
    });
  }
}

TEST(CorrosionStatistics, MetalEndsWithTheMaterials) {
  const Material steel = find_material("bare-steel");
  const auto p = with_lifetime({}, steel, ExposureClass::CX, 0.1);
  const double years = metal_lifetime(steel, ExposureClass::CX);
  EXPECT_NEAR(static_cast<double>(p.thickness.lifetime()) * 0.1, years, 0.1);
}

TEST(CorrosionStatistics, EarlierStepsAreRemembered) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.05});
  CorrosionGrowth growth({s, 3, random_seeds(s, 3, 3)}, {});
  CorrosionStatistics statistics(scale_of(growth, 0.1, 8.96));
  std::vector<CorrosionNumbers> then;
  for (int step = 0; step < 40; ++step) {
    growth.step();
    then.push_back(statistics.measure(growth, true));
  }
  for (const CorrosionNumbers& expected : then) {
    const CorrosionNumbers numbers = statistics.measure_at(growth, expected.step, true);
    EXPECT_EQ(numbers.corroded, expected.corroded);
    EXPECT_EQ(numbers.new_cells, expected.new_cells);
    EXPECT_EQ(numbers.mean_depth, expected.mean_depth);
    EXPECT_EQ(numbers.spots->sizes, expected.spots->sizes);
    EXPECT_EQ(numbers.spots->perimeter, expected.spots->perimeter);
  }
}

TEST(CorrosionStatistics, TablesHoldARowAStep) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.05});
  CorrosionGrowth growth({s, 3, random_seeds(s, 3, 3)}, {});
  CorrosionStatistics statistics(scale_of(growth, 0.1, 8.96));
  std::vector<CorrosionNumbers> numbers;
  for (int step = 0; step < 20; ++step) {
    growth.step();
    numbers.push_back(statistics.measure(growth, step % 10 == 9));
  }
  const auto folder = std::filesystem::temp_directory_path();
  const auto lines_of = [&](const char* name, auto&& write) {
    const auto file = folder / name;
    write(file, numbers);
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    std::filesystem::remove(file);
    return lines;
  };
  const auto table = lines_of("verdigris_corrosion_test.csv", write_corrosion_csv);
  ASSERT_EQ(table.size(), 21u);
  for (const std::string& line : table) EXPECT_EQ(std::count(line.begin(), line.end(), ','), 13) << line;
  EXPECT_TRUE(table[1].ends_with(",,,"));
  EXPECT_FALSE(table[10].ends_with(","));
  EXPECT_GT(lines_of("verdigris_spots_test.csv", write_spots_csv).size(), 2u);
}

// Spots.
Field<SpotCell> cells_in(const Surface& s, const std::function<bool(glm::dvec3)>& in) {
  Field<SpotCell> cells(s.slot_count(), SpotCell::nothing);
  each_owned(s,
             [&](std::uint32_t slot) { cells[slot] = in(s.position(slot)) ? SpotCell::in : SpotCell::out; });
  s.links().for_each([&](std::uint32_t source, auto ghosts) {
    for (const std::uint32_t ghost : ghosts) cells[ghost] = cells[source];
  });
  return cells;
}

TEST(Spots, DiscsOnAnyTriangulationHaveTheirAreaAndRim) {
  for (const Mesh& mesh :
       {shapes::plain(120), shapes::random_plane(9, 120, 2), shapes::random_plane(40, 120, 2)}) {
    const Surface s = make_surface(mesh, {.cell_size = 1.0});
    const glm::dvec3 centres[] = {{-60, 0, 0}, {30, 20, 0}, {30, -40, 0}};
    const double radii[] = {40, 30, 12};
    const Spots spots = measure_spots(s, cells_in(s, [&](glm::dvec3 p) {
                                        for (int k = 0; k < 3; ++k)
                                          if (glm::length(p - centres[k]) < radii[k]) return true;
                                        return false;
                                      }));
    ASSERT_EQ(spots.sizes.size(), 3u);
    double rim = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(static_cast<double>(spots.sizes[k]), std::numbers::pi * radii[k] * radii[k],
                  0.02 * std::numbers::pi * radii[k] * radii[k]);
      rim += 2.0 * std::numbers::pi * radii[k];
    }
    EXPECT_NEAR(spots.perimeter, rim, 0.03 * rim);
  }
}

TEST(Spots, AreJoinedAcrossEdgesOnly) {
  const Surface s = make_surface(shapes::torus(3, 1, 90, 40), {.cell_size = 0.07});
  const Spots all = measure_spots(s, cells_in(s, [](glm::dvec3) { return true; }));
  ASSERT_EQ(all.sizes.size(), 1u);
  EXPECT_EQ(all.sizes[0], s.owned_count());
  EXPECT_EQ(all.perimeter, 0.0);
  const Spots halves = measure_spots(s, cells_in(s, [](glm::dvec3 p) { return std::abs(p.x) > 0.3; }));
  EXPECT_EQ(halves.sizes.size(), 2u);
  // Four circles. With some ten cells a triangle, pairs across edges are counted about a tenth too often.
  EXPECT_NEAR(halves.perimeter, 4 * 2.0 * std::numbers::pi, 0.15 * 4 * 2.0 * std::numbers::pi);
  EXPECT_EQ(spot_histogram({{9, 8, 3, 2, 1, 1}, 0.0}), (std::vector<std::uint64_t>{2, 2, 0, 2}));
}

TEST(Spots, BoundariesAreNoRim) {
  const Surface s = make_surface(shapes::square(40), {.cell_size = 1.0});
  EXPECT_EQ(measure_spots(s, cells_in(s, [](glm::dvec3) { return true; })).perimeter, 0.0);
}

}  // namespace
