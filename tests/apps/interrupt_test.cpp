// Stopping a long run.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "cells_file.hpp"
#include "program.hpp"

namespace {

using namespace std::chrono_literals;

// A run that would take days: each seed has a face of the cube to itself, and the second spreads once in
// 10^12 steps.
TEST(Interrupt, LeavesResultsThatCanBeReadAndRepeated) {
  const Workplace place;
  const std::string seeds = place.file("seeds.txt", "0.5 0.5 1\n0.5 0.5 0 1e-12\n");
  Running running({"voronoi", place.cube(), "--cells", "600", "--seeds", seeds, "--barrier-angle", "45",
                   "--no-picture", "--out", place.path("out")});
  for (int wait = 0; wait < 3000 && !std::filesystem::exists(place.path("out")); ++wait)
    std::this_thread::sleep_for(10ms);
  std::this_thread::sleep_for(500ms);
  ASSERT_FALSE(running.ended());
  running.signal(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("stopped after step"), std::string::npos) << outcome.err;

  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  EXPECT_EQ(cells.label[cells.nearest({0.1, 0.1, 1.0})], 0);
  EXPECT_EQ(cells.label[cells.nearest({0.1, 0.1, 0.0})], -1);
  EXPECT_EQ(read_table(place.path("out/regions.csv")).size(), 2u);

  const Outcome again = verdigris({"run", place.path("out/run.toml"), "--out", place.path("again")});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(content_of(place.path("again/cells.vtp")), content_of(place.path("out/cells.vtp")));
}

}  // namespace
