// Edges and masks that growth does not cross.
#include <gtest/gtest.h>

#include <cmath>

#include "cells_file.hpp"
#include "program.hpp"

namespace {

// The cube's squares in file order, each cut into two triangles.
bool on_top(std::int32_t patch) {
  return patch / 2 == 1;
}

TEST(Barrier, AngleKeepsGrowthOnOneFaceOfACube) {
  const Workplace place;
  const std::string seeds = place.file("seeds.txt", "0.3 0.4 1\n"), out = place.path("out");
  const Outcome outcome = verdigris({"voronoi", place.cube(), "--cells", "24k", "--seeds", seeds,
                                     "--barrier-angle", "45", "--no-picture", "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  for (std::size_t k = 0; k < cells.label.size(); ++k)
    ASSERT_EQ(cells.label[k], on_top(cells.patch[k]) ? 0 : -1)
        << "cell " << k << " of patch " << cells.patch[k];
  EXPECT_NEAR(read_table(place.path("out/regions.csv"))[0][5], 1.0, 0.02);  // its area
}

TEST(Barrier, AngleAboveThatOfTheEdgesChangesNothing) {
  const Workplace place;
  for (const char* angle : {"91", "180"}) {
    ASSERT_EQ(verdigris({"voronoi", place.cube(), "--cells", "6k", "--seeds", "4", "--barrier-angle", angle,
                         "--no-picture", "--out", place.path(angle)})
                  .status,
              0);
  }
  ASSERT_EQ(verdigris({"voronoi", place.cube(), "--cells", "6k", "--seeds", "4", "--no-picture", "--out",
                       place.path("none")})
                .status,
            0);
  EXPECT_EQ(content_of(place.path("91/cells.vtp")), content_of(place.path("none/cells.vtp")));
  EXPECT_EQ(content_of(place.path("180/cells.vtp")), content_of(place.path("none/cells.vtp")));
}

TEST(Barrier, MaskOfFacesStaysEmpty) {
  const Workplace place;
  const std::string mask = place.file("mask.txt", "0\n1\n0\n0\n0\n0\n"), out = place.path("out");
  const Outcome outcome = verdigris({"voronoi", place.cube(), "--cells", "24k", "--seeds", "6",
                                     "--barrier-mask", mask, "--no-picture", "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  for (std::size_t k = 0; k < cells.label.size(); ++k)
    ASSERT_EQ(cells.label[k] == -1, on_top(cells.patch[k])) << "cell " << k;
}

TEST(Barrier, MaskOfVerticesBarsFromTheThresholdOn) {
  const Workplace place;
  // 1 at the top, 0 at the bottom: the upper quarter is barred.
  const std::string mask = place.file("mask.txt", "0\n0\n0\n0\n1\n1\n1\n1\n"), out = place.path("out");
  const Outcome outcome =
      verdigris({"voronoi", place.cube(), "--cells", "24k", "--seeds", "6", "--barrier-mask", mask,
                 "--barrier-threshold", "0.75", "--no-picture", "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  for (std::size_t k = 0; k < cells.label.size(); ++k)
    if (std::abs(cells.points[k].z - 0.75) > 1e-6) {
      ASSERT_EQ(cells.label[k] == -1, cells.points[k].z > 0.75) << "cell " << k;
    }
}

}  // namespace
