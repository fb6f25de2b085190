// The lsystem command: lines, solids, and drawings on models that others can grow from.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cells_file.hpp"
#include "program.hpp"

namespace {

nlohmann::json report_of(Arguments arguments) {
  arguments.insert(arguments.begin(), "lsystem");
  arguments.push_back("--json");
  const Outcome outcome = verdigris(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return outcome.status == 0 ? nlohmann::json::parse(outcome.out) : nlohmann::json();
}

TEST(LSystemCommand, PrintsWords) {
  EXPECT_EQ(verdigris({"lsystem", "algae", "-n", "4", "--word"}).out, "ABBAB\n");
  const Workplace place;
  const std::string grammar = place.file("own.txt", "axiom = F(1)\nF(x) -> F(x / 2)[+F(x)]\n");
  EXPECT_EQ(verdigris({"lsystem", grammar, "-n", "1", "--word"}).out, "F(0.5)[+F(1)]\n");
}

TEST(LSystemCommand, DrawsLinesInAllFormats) {
  const Workplace place;
  for (const char* name : {"koch.svg", "koch.obj", "koch.vtp"}) {
    const auto report = report_of({"koch-curve", "-n", "3", "--extent", "2", "-o", place.path(name)});
    EXPECT_EQ(report["points"], 65);
    EXPECT_NEAR(report["length"], 2.0 * 64.0 / 27.0, 1e-9);
    EXPECT_TRUE(std::filesystem::is_regular_file(place.path(name)));
  }
  EXPECT_EQ(content_of(place.path("koch.svg")).substr(0, 4), "<svg");
}

TEST(LSystemCommand, TubesAreSoundModels) {
  const Workplace place;
  for (const char* name : {"tree.obj", "tree.ply"}) {
    const std::string file = place.path(name);
    const auto report = report_of({"ternary-tree", "-n", "3", "--tubes", "-o", file});
    const Outcome info = verdigris({"info", file, "--json"});
    ASSERT_EQ(info.status, 0) << info.err;
    const auto found = nlohmann::json::parse(info.out);
    EXPECT_TRUE(found["closed"]);
    EXPECT_EQ(found["non_manifold_vertices"], 0);
    EXPECT_EQ(found["degenerate_triangles"], 0);
    EXPECT_EQ(found["vertices_welded"], 0);
    EXPECT_EQ(found["triangles"], report["triangles"]);
    EXPECT_EQ(found["components"], 64);
  }
}

TEST(LSystemCommand, WalksOnModelsAndSeedsGrowth) {
  const Workplace place;
  const std::string cube = place.cube(), seeds = place.path("seeds.txt");
  const Arguments arguments{"koch-curve",
                            "-n",
                            "2",
                            "--on",
                            cube,
                            "--at",
                            "0.2,0.5,1",
                            "--heading",
                            "1,0,0",
                            "--extent",
                            "1.5",
                            "--cells",
                            "20k",
                            "--seed-points",
                            seeds,
                            "-o",
                            place.path("on.vtp")};
  const auto report = report_of(arguments);
  EXPECT_EQ(report["stopped_at_boundary"], 0);
  EXPECT_NEAR(report["length"], 1.5 * 16.0 / 9.0, 1e-9);
  const std::string lines = content_of(place.path("on.vtp")), points = content_of(seeds);
  const Outcome grown = verdigris(
      {"voronoi", cube, "--cells", "20k", "--seeds", seeds, "--no-picture", "--out", place.path("grown")});
  ASSERT_EQ(grown.status, 0) << grown.err;
  EXPECT_EQ(grown.err.find("warning"), std::string::npos) << grown.err;
  EXPECT_EQ(read_table(place.path("grown/regions.csv")).size(), report["seed_points"]);
  report_of(arguments);
  EXPECT_EQ(content_of(place.path("on.vtp")), lines);
  EXPECT_EQ(content_of(seeds), points);
}

TEST(LSystemCommand, TheSeedMakesTheDrawing) {
  const Workplace place;
  const auto draw = [&](const char* seed) {
    report_of({"stochastic-plant", "--threads", "1", "--seed", seed, "-o", place.path("plant.svg")});
    return content_of(place.path("plant.svg"));
  };
  const std::string one = draw("1");
  EXPECT_EQ(draw("1"), one);
  EXPECT_NE(draw("2"), one);
}

TEST(LSystemCommand, RefusesWhatItCannotUse) {
  const Workplace place;
  const std::string out = place.path("out.svg"), cube = place.cube();
  const auto expect = [&](Arguments arguments, const std::string& where) {
    arguments.insert(arguments.begin(), "lsystem");
    arguments.insert(arguments.end(), {"--out", out});
    expect_refused(verdigris(arguments), where, out);
  };
  expect({"oak"}, "oak");
  expect({place.path("none.txt")}, "none.txt");
  expect({place.file("bad.txt", "axiom = F\nF -> F[\n")}, "bad.txt:2:7");
  expect({"koch-curve", "-n", "40"}, "iterations");
  expect({"koch-curve", "-n", "-1"}, "--iterations");
  expect({"koch-curve", "--angle", "steep"}, "--angle");
  expect({"koch-curve", "--step", "0"}, "--step");
  expect({"koch-curve", "--step", "1", "--extent", "1"}, "--extent");
  expect({"koch-curve", "--seed-points", place.path("seeds.txt")}, "--seed-points");
  expect({"koch-curve", "--at", "1,2,3"}, "--at");
  expect({"koch-curve", "--heading", "1,2,3"}, "--heading");
  expect({"koch-curve", "--cells", "1k"}, "--cells");
  expect({"koch-curve", "--sides", "5"}, "--sides");
  expect({"koch-curve", "--on", cube, "--spacing", "1"}, "--spacing");
  expect({"koch-curve", "--on", place.path("none.obj")}, "none.obj");
  expect({"koch-curve", "--on", cube, "--at", "1,2"}, "--at");
  expect({"koch-curve", "--on", cube, "--at", "1,2,nan"}, "--at");
  expect({"koch-curve", "--tubes", "--sides", "2"}, "--sides");
  expect({"koch-curve", "--tubes"}, ".obj or .ply");
  const std::string huge = place.file("huge.txt", "axiom = F(1e300)F(1e300)\nstep = 1e9\n");
  expect({huge}, "turtle");
  expect({huge, "--on", cube}, "turtle");
  expect_refused(verdigris({"lsystem", huge, "--tubes", "-o", place.path("huge.obj")}), "turtle",
                 place.path("huge.obj"));
  expect_refused(verdigris({"lsystem", "koch-curve", "--on", cube, "--seed-points", place.path("points.txt"),
                            "-o", place.path("koch.png")}),
                 ".png", place.path("points.txt"));
  expect_refused(verdigris({"lsystem", "koch-curve", "-o", place.path("koch.png")}), ".png",
                 place.path("koch.png"));
  expect_refused(verdigris({"lsystem", "koch-curve", "-o", place.path("no/koch.svg")}), "koch.svg",
                 place.path("no"));
}

}  // namespace
