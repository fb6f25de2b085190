// Where growth starts, how fast, and for how long.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cells_file.hpp"
#include "program.hpp"

namespace {

CellsFile grow(const Workplace& place, Arguments options) {
  Arguments arguments{"voronoi", place.cube(), "--cells", "24k", "--no-picture", "--out", place.path("out")};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = verdigris(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read_cells(place.path("out/cells.vtp"));
}

// Label k starts at points[k].
void expect_starts_at(const Workplace& place, const CellsFile& cells, const std::vector<glm::dvec3>& points) {
  const auto regions = read_table(place.path("out/regions.csv"));
  ASSERT_EQ(regions.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    SCOPED_TRACE(k);
    const glm::dvec3 seed(regions[k][1], regions[k][2], regions[k][3]);
    EXPECT_LE(glm::distance(seed, points[k]), std::sqrt(cells.area[0]));  // a cell's side
    const std::size_t cell = cells.nearest(seed);
    EXPECT_EQ(cells.label[cell], static_cast<std::int32_t>(k));
    EXPECT_EQ(cells.arrival[cell], 0);
  }
  EXPECT_EQ(std::count(cells.arrival.begin(), cells.arrival.end(), 0),
            static_cast<std::ptrdiff_t>(points.size()));
}

TEST(Seeds, LineOfAFileIsLabel) {
  const Workplace place;
  const std::string seeds =
      place.file("seeds.txt", "# x y z\n0.3 0.4 1\n1, 0.7, 0.2\n\n0.25\t0.5 0  # below\n");
  const CellsFile cells = grow(place, {"--seeds", seeds});
  expect_starts_at(place, cells, {{0.3, 0.4, 1.0}, {1.0, 0.7, 0.2}, {0.25, 0.5, 0.0}});
}

TEST(Seeds, VerticesCountFromZero) {
  const Workplace place;
  const CellsFile cells = grow(place, {"--seed-vertices", "6,0,5"});
  expect_starts_at(place, cells, {{1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, {1.0, 0.0, 1.0}});
}

TEST(Seeds, PointsOffTheSurfaceAreMovedThereWithAWarning) {
  const Workplace place;
  const std::string seeds = place.file("seeds.txt", "0.5 0.5 3\n");
  const Outcome outcome = verdigris({"voronoi", place.cube(), "--cells", "600", "--seeds", seeds,
                                     "--no-picture", "--out", place.path("out")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("warning"), std::string::npos) << outcome.err;
  EXPECT_NEAR(read_table(place.path("out/regions.csv"))[0][3], 1.0, 1e-9);
}

TEST(Seeds, FromOneSeedEveryCellIsReached) {
  const Workplace place;
  for (const char* links : {"unfolded", "projected"}) {
    SCOPED_TRACE(links);
    const CellsFile cells = grow(place, {"--seeds", "1", "--links", links});
    EXPECT_EQ(std::count(cells.label.begin(), cells.label.end(), 0),
              static_cast<std::ptrdiff_t>(cells.label.size()));
  }
}

// Two seeds opposite each other: speeds 1 and 2 meet where arrival steps over speeds agree.
TEST(Seeds, WeightsAreSpeeds) {
  const Workplace place;
  grow(place, {"--seeds", place.file("seeds.txt", "0.5 0.5 0\n0.5 0.5 1\n")});
  const double equal = read_table(place.path("out/regions.csv"))[1][6];
  EXPECT_NEAR(equal, 0.5, 0.02);
  grow(place, {"--seeds", place.file("seeds.txt", "0.5 0.5 0 1\n0.5 0.5 1 2\n")});
  const double from_file = read_table(place.path("out/regions.csv"))[1][6];
  EXPECT_GT(from_file, 0.6);
  // The same weights as an option, in another unit: only their ratio counts.
  grow(place, {"--seeds", place.file("seeds.txt", "0.5 0.5 0\n0.5 0.5 1\n"), "--seed-weights", "3,6"});
  EXPECT_EQ(read_table(place.path("out/regions.csv"))[1][6], from_file);
}

TEST(Seeds, StepsLimitGrowth) {
  const Workplace place;
  const CellsFile cells = grow(place, {"--seeds", place.file("seeds.txt", "0.5 0.5 1\n"), "--steps", "5"});
  EXPECT_EQ(*std::max_element(cells.arrival.begin(), cells.arrival.end()), 5);
  EXPECT_GT(std::count(cells.label.begin(), cells.label.end(), -1), 0);
  for (std::size_t k = 0; k < cells.label.size(); ++k)
    ASSERT_EQ(cells.label[k] == -1, cells.arrival[k] == -1);
  EXPECT_EQ(read_table(place.path("out/curve.csv")).size(), 6u);
}

// What the first five steps do, a longer run does too.
TEST(Seeds, StoppedGrowthIsTheBeginningOfAllGrowth) {
  const Workplace place;
  const CellsFile some = grow(place, {"--seeds", "3", "--steps", "5"});
  const CellsFile all = grow(place, {"--seeds", "3"});
  for (std::size_t k = 0; k < some.label.size(); ++k)
    ASSERT_EQ(some.label[k], all.arrival[k] <= 5 ? all.label[k] : -1) << "cell " << k;
}

}  // namespace
