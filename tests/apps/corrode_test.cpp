// verdigris corrode: what it writes, that it repeats and goes on to the bit, and what it refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "program.hpp"

namespace {

namespace fs = std::filesystem;
const std::string cup = VERDIGRIS_MESHES "/cup.obj";

std::vector<std::string> lines_of(const fs::path& file) {
  std::istringstream in(content_of(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

TEST(Corrode, WritesNumbersCurvesAndCellsInRealUnits) {
  const Workplace place;
  const Outcome run = verdigris({"corrode", cup, "--cells", "20k", "--years", "12", "--steps", "300",
                                 "--class", "C5", "--no-picture", "--out", place.path("out")});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto table = lines_of(place.path("out/statistics.csv"));
  ASSERT_EQ(table.size(), 302u);
  EXPECT_TRUE(table[0].starts_with("step,years,new_cells,corroded_cells")) << table[0];
  EXPECT_TRUE(table[301].starts_with("300,12,")) << table[301];
  EXPECT_GT(lines_of(place.path("out/spots.csv")).size(), 5u);
  for (const char* plot : {"share.png", "loss.png", "spots.png"})
    EXPECT_EQ(content_of(place.path("out") / plot).substr(1, 3), "PNG");
  const std::string cells = content_of(place.path("out/cells.vtp")).substr(0, 4000);
  for (const char* field :
       {"age_years", "metal_lost_um", "metal_left_um", "cuprite_um", "brochantite_um", "state"})
    EXPECT_NE(cells.find('"' + std::string(field) + '"'), std::string::npos) << field;
}

void expect_same_files(const fs::path& first, const fs::path& again) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(first)) {
    EXPECT_EQ(content_of(entry.path()), content_of(again / entry.path().filename())) << entry.path();
    ++files;
  }
  EXPECT_GE(files, 7u);
}

TEST(Corrode, RunTomlRepeatsIt) {
  const Workplace place;
  const Outcome first = verdigris({"corrode",       cup,
                                   "--cells",       "15k",
                                   "--material",    "bare-steel",
                                   "--class",       "CX",
                                   "--step-length", "8w",
                                   "--years",       "20",
                                   "--seed",        "9",
                                   "--strong",      "0.1",
                                   "--threads",     "2",
                                   "--holes",       "--no-picture",
                                   "--out",         place.path("first")});
  ASSERT_EQ(first.status, 0) << first.err;
  const Outcome again =
      verdigris({"run", place.path("first/run.toml"), "--threads", "1", "--out", place.path("again")});
  ASSERT_EQ(again.status, 0) << again.err;
  expect_same_files(place.path("first"), place.path("again"));
}

TEST(Corrode, GoesOnFromACheckpointAsIfNeverStopped) {
  const Workplace place;
  const Arguments run{"corrode", cup, "--cells", "60k", "--steps", "600", "--no-picture", "--quiet"};
  const auto with = [&](Arguments more) {
    more.insert(more.begin(), run.begin(), run.end());
    return more;
  };
  ASSERT_EQ(verdigris(with({"--out", place.path("whole")})).status, 0);
  Running stopped(with({"--out", place.path("parts"), "--checkpoint-every", "50"}));
  while (!fs::exists(place.path("parts/checkpoint.vgc")) && !stopped.ended())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  stopped.signal(SIGKILL);
  stopped.wait();
  if (fs::exists(place.path("parts/checkpoint.vgc"))) {
    ASSERT_EQ(verdigris(with({"--out", place.path("parts"), "--resume"})).status, 0);
  }
  expect_same_files(place.path("whole"), place.path("parts"));
}

TEST(Corrode, MasksOfASceneReachIt) {
  const Workplace place;
  const Outcome first = verdigris(
      {"corrode", cup, "--cells", "10k", "--steps", "200", "--no-picture", "--out", place.path("plain")});
  ASSERT_EQ(first.status, 0) << first.err;
  std::string scene = content_of(place.path("plain/run.toml"));
  scene.insert(scene.find("[barrier]"), "[masks.rate]\nsource = \"fbm\"\n\n");
  std::ofstream(place.path("plain/masked.toml")) << scene;
  const Outcome masked = verdigris({"run", place.path("plain/masked.toml"), "--out", place.path("masked")});
  ASSERT_EQ(masked.status, 0) << masked.err;
  EXPECT_NE(content_of(place.path("masked/cells.vtp")).find("mask_rate"), std::string::npos);
  EXPECT_NE(content_of(place.path("masked/statistics.csv")), content_of(place.path("plain/statistics.csv")));
}

#ifdef VERDIGRIS_WITH_GL
TEST(Corrode, DrawsTheAgesAskedFor) {
  const Workplace place;
  const Outcome run =
      verdigris({"corrode", cup, "--cells", "5k", "--years", "10", "--steps", "200", "--frames", "0,2.5,10",
                 "--exaggerate", "60", "--size", "160x120", "--out", place.path("out")});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* name :
       {"patina-000.000y.png", "patina-002.500y.png", "patina-010.000y.png", "picture.png"})
    EXPECT_EQ(content_of(place.path("out") / name).substr(1, 3), "PNG") << name;
  EXPECT_EQ(content_of(place.path("out/patina-010.000y.png")), content_of(place.path("out/picture.png")));
}

TEST(Figures, AreOnePage) {
  const Workplace place;
  const Outcome run = verdigris({"figures", place.path("out")});
  ASSERT_EQ(run.status, 0) << run.err;
  const std::string page = content_of(place.path("out/index.html"));
  for (const char* title : {"Figure 2:", "Figure 8:", "Figure 10:", "Figure 16:", "Figure 17:", "Figure 21:",
                            "Figure 22:", "Figure 23:"})
    EXPECT_NE(page.find(title), std::string::npos) << title;
  EXPECT_EQ(page.find("src=\"figure"), std::string::npos);
}
#endif

TEST(Corrode, RefusesWhatItCannotDo) {
  const Workplace place;
  const auto refused = [&](Arguments more, const char* where) {
    more.insert(more.begin(), {"corrode", cup, "--no-picture", "--out", place.path("out")});
    expect_refused(verdigris(more), where, place.path("out"));
  };
  refused({"--material", "cheese"}, "material");
  refused({"--class", "C9"}, "C9");
  refused({"--years", "nan"}, "--years");
  refused({"--unit", "nan"}, "--unit");
  refused({"--step-length", "3 apples"}, "--step-length");
  refused({"--step-length", "1d", "--years", "3", "--steps", "10"}, "--years");
  refused({"--frames", "1,x"}, "--frames");
  refused({"--frames", "2.5"}, "--frames");
  refused({"--years", "-1"}, "--years");
  const std::string scene =
      place.file("s.toml", "[mesh]\nfile = \"" + cup +
                               "\"\n[behaviour]\nname = \"voronoi\"\n[seeds]\ncount = 3\n"
                               "[corrosion]\nmaterial = \"copper\"\nstep_years = 0.1\n");
  expect_refused(verdigris({"run", scene, "--out", place.path("out")}), "does not corrode",
                 place.path("out"));
}

}  // namespace
