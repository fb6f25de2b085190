// What the program says: help, and reports for people and for programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cells_file.hpp"
#include "program.hpp"

namespace {

TEST(Report, HelpOfEveryCommand) {
  for (const Arguments& arguments : {Arguments{"--help"},
                                     {"--version"},
                                     {"info", "--help"},
                                     {"voronoi", "--help"},
                                     {"run", "--help"},
                                     {"list", "--help"}}) {
    const Outcome outcome = verdigris(arguments);
    EXPECT_EQ(outcome.status, 0) << arguments[0];
    EXPECT_FALSE(outcome.out.empty()) << arguments[0];
    EXPECT_EQ(outcome.err, "") << arguments[0];
  }
}

// One object on standard output, nothing else anywhere.
nlohmann::json json_of(const Arguments& arguments) {
  const Outcome outcome = verdigris(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const nlohmann::json report = nlohmann::json::parse(outcome.out, nullptr, false);
  EXPECT_TRUE(report.is_object()) << outcome.out;
  return report;
}

TEST(Report, JsonOfInfo) {
  const Workplace place;
  const auto report = json_of({"info", place.cube(), "--json"});
  EXPECT_EQ(report["triangles"], 12);
  EXPECT_EQ(report["vertices"], 8);
  EXPECT_EQ(report["components"], 1);
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["boundary_loops"], 0);
  EXPECT_DOUBLE_EQ(report["area"].get<double>(), 6.0);
  EXPECT_GT(report["suggested"]["cell_size"].get<double>(), 0.0);
  EXPECT_GT(report["suggested"]["cells"].get<double>(), 0.0);
}

TEST(Report, JsonOfARunAndOfItsRepetition) {
  const Workplace place;
  const auto report = json_of({"voronoi", place.cube(), "--cells", "6k", "--seeds", "5", "--no-picture",
                               "--json", "--out", place.path("out")});
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  EXPECT_EQ(report["cells"], cells.points.size());
  EXPECT_EQ(report["seeds"], 5);
  EXPECT_EQ(report["complete"], true);
  EXPECT_EQ(report["cells_not_reached"], 0);
  EXPECT_EQ(report["files"].size(), 4u);
  for (const auto& file : report["files"])
    EXPECT_TRUE(std::filesystem::is_regular_file(place.path("out") / file.get<std::string>())) << file;
  const auto again = json_of({"run", place.path("out/run.toml"), "--json", "--out", place.path("again")});
  EXPECT_EQ(again["mesh_hash"], report["mesh_hash"]);
  EXPECT_EQ(again["steps"], report["steps"]);
}

TEST(Report, JsonOfList) {
  const auto report = json_of({"list", "--json"});
  ASSERT_FALSE(report["behaviours"].empty());
  EXPECT_EQ(report["behaviours"][0]["name"], "voronoi");
  EXPECT_EQ(report["behaviours"][0]["parameters"][0]["name"], "corner");
}

TEST(Report, QuietSaysNothing) {
  const Workplace place;
  const Outcome outcome = verdigris({"voronoi", place.cube(), "--cells", "600", "--seeds", "2",
                                     "--no-picture", "--quiet", "--out", place.path("out")});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

// Tables agree with each other and with the cells.
TEST(Report, TablesAddUp) {
  const Workplace place;
  ASSERT_EQ(verdigris({"voronoi", place.cube(), "--cells", "6k", "--seeds", "5", "--no-picture", "--out",
                       place.path("out")})
                .status,
            0);
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  const double n = static_cast<double>(cells.label.size());
  double counted = 0.0, share = 0.0;
  for (const auto& row : read_table(place.path("out/regions.csv"))) {
    counted += row[4];
    share += row[6];
    EXPECT_NEAR(row[5], row[4] * cells.area[0], 1e-6);
    EXPECT_EQ(row[4], static_cast<double>(std::count(cells.label.begin(), cells.label.end(),
                                                     static_cast<std::int32_t>(row[0]))));
  }
  EXPECT_EQ(counted, n);
  EXPECT_NEAR(share, 1.0, 1e-7);
  const auto curve = read_table(place.path("out/curve.csv"));
  double filled = 0.0;
  for (std::size_t step = 0; step < curve.size(); ++step) {
    EXPECT_EQ(curve[step][0], static_cast<double>(step));
    EXPECT_EQ(curve[step][1], static_cast<double>(std::count(cells.arrival.begin(), cells.arrival.end(),
                                                             static_cast<std::int32_t>(step))));
    filled += curve[step][1];
    EXPECT_NEAR(curve[step][2], filled / n, 1e-8);
  }
  EXPECT_EQ(filled, n);
}

}  // namespace
