// The weather command: timelines from a scene to files.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "program.hpp"

namespace {

const char* const good =
    "timeline = [\n  { op = \"coat\", thickness = 50, variation = 0.0 },\n"
    "  { op = \"scratch\", count = 4 },\n"
    "  { op = \"age\", class = \"C5\", years = 3, spread = 0.05, seeding = \"bare\" },\n]\n\n"
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 6000\n\n[picture]\ndraw = false\n\n"
    "[weathering]\nmaterial = \"bare-steel\"\n";

TEST(Weather, WritesCellsTableAndASceneThatRepeatsIt) {
  const Workplace place;
  place.cube();
  const std::string scene = place.file("scene.toml", good), out = place.path("out"),
                    again = place.path("again");
  ASSERT_EQ(verdigris({"weather", scene, "--out", out}).status, 0);
  const std::string table = content_of(place.path("out") / "timeline.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_NE(table.find("paint_um"), std::string::npos);
  for (const char* command : {"run", "weather"}) {
    ASSERT_EQ(verdigris({command, out + "/run.toml", "--out", again, "--threads", "1"}).status, 0);
    EXPECT_EQ(content_of(place.path("again") / "cells.vtp"), content_of(place.path("out") / "cells.vtp"));
  }
}

TEST(Weather, RefusesBadTimelinesByLine) {
  const std::vector<Fault> faults{
      {"\"coat\"", "\"gild\"", "scene.toml:2"},
      {"op = \"scratch\", ", "", "scene.toml:3"},
      {"count = 4", "cout = 4", "scene.toml:3"},
      {"count = 4", "count = true", "scene.toml:3"},
      {"years = 3", "years = 9223372036854775807", "scene.toml:4"},
      {"thickness = 50", "thickness = 50, colour = \"red\"", "scene.toml:2"},
      {"C5", "C6", "scene.toml:4"},
      {"seeding = \"bare\"", "seeding = \"bear\"", "scene.toml:4"},
      {"bare-steel", "kryptonite", "kryptonite"},
      {"[weathering]\nmaterial = \"bare-steel\"", "", "scene.toml"},
      {"material", "metal", "scene.toml"},
  };
  expect_faults_refused("weather", good, faults);
}

TEST(Weather, KeepsEarlierResultsUntilItHasItsOwn) {
  const Workplace place;
  place.cube();
  const std::string out = place.path("out");
  ASSERT_EQ(verdigris({"weather", place.file("scene.toml", good), "--out", out}).status, 0);
  std::string bad = good;
  bad.replace(bad.find("]\n\n[mesh]"), 1, "  { op = \"coat\", layer = \"paint\" },\n]");
  const char* const results[] = {"cells.vtp", "timeline.csv", "run.toml"};
  std::vector<std::string> before;
  for (const char* file : results) before.push_back(content_of(place.path("out") / file));
  const Outcome outcome = verdigris({"weather", place.file("bad.toml", bad), "--out", out});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("bad.toml:5"), std::string::npos) << outcome.err;
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_TRUE(content_of(place.path("out") / results[k]) == before[k]) << results[k];
  // A scene may lie where its results go; what it reads may not.
  EXPECT_EQ(verdigris({"weather", out + "/run.toml", "--out", out}).status, 0);
  std::filesystem::copy_file(place.path("cube.obj"), place.path("out") / "picture.png");
  EXPECT_EQ(
      verdigris({"weather", place.path("scene.toml"), "--mesh", out + "/picture.png", "--out", out}).status,
      2);
}

TEST(Weather, PresetsReadAndTakeAnyModel) {
  const Workplace place;
  const std::string cube = place.cube();
  int presets = 0;
  for (const auto& entry : std::filesystem::directory_iterator(VERDIGRIS_MESHES "/../presets")) {
    const std::string text = content_of(entry.path());
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40) << entry.path();
    const auto outcome = verdigris({"weather", entry.path(), "--mesh", cube, "--cells", "4000",
                                    "--no-picture", "--out", place.path("out")});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    ++presets;
  }
  EXPECT_EQ(presets, 5);
}

}  // namespace
