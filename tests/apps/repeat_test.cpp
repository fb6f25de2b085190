// run.toml repeats a run to the bit, with any number of threads.
#include <gtest/gtest.h>

#include "program.hpp"

namespace {

void expect_repeated(const Workplace& place, Arguments arguments) {
  const Arguments fixed{"--threads", "2", "--out", place.path("first")};
  arguments.insert(arguments.end(), fixed.begin(), fixed.end());
  const Outcome first = verdigris(arguments);
  ASSERT_EQ(first.status, 0) << first.err;
  const Outcome again =
      verdigris({"run", place.path("first/run.toml"), "--threads", "1", "--out", place.path("again")});
  ASSERT_EQ(again.status, 0) << again.err;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(place.path("first"))) {
    const std::string name = entry.path().filename();
    EXPECT_EQ(content_of(entry.path()), content_of(place.path("again") / name)) << name << " differs";
    ++files;
  }
  EXPECT_GE(files, 4u);
}

TEST(Repeat, RandomSeeds) {
  const Workplace place;
  expect_repeated(
      place, {"voronoi", place.cube(), "--cells", "200k", "--seeds", "20", "--seed", "7", "--no-picture"});
}

TEST(Repeat, SeedsFromAFileWithWeightsAndBarriers) {
  const Workplace place;
  const std::string seeds =
      place.file("seeds.txt", "0.31 0.42 1 1.5\n0.1 0.2 0 1\n1 0.123456789012345 0.6 0.7\n");
  const std::string mask = place.file("mask.txt", "0\n0\n0\n0\n0\n1\n");
  expect_repeated(place, {"voronoi", place.cube(), "--cell-size", "0.0073", "--seeds", seeds, "--corner",
                          "0.3", "--barrier-mask", mask, "--steps", "40", "--no-picture"});
}

TEST(Repeat, ProjectedLinks) {
  const Workplace place;
  expect_repeated(place, {"voronoi", place.cube(), "--cells", "50k", "--seed-vertices", "0,6",
                          "--seed-weights", "1,2", "--links", "projected", "--no-picture"});
}

#ifdef VERDIGRIS_WITH_GL
TEST(Repeat, Picture) {
  const Workplace place;
  expect_repeated(place, {"voronoi", place.cube(), "--cells", "20k", "--seeds", "9", "--size", "320x200",
                          "--view", "1,2,3", "--up", "z", "--no-outline"});
  EXPECT_EQ(content_of(place.path("first/picture.png")).substr(1, 3), "PNG");
}
#endif

// Random seeds keep their labels when the number of threads differs; another --seed gives others.
TEST(Repeat, SeedOfTheRandomNumbersMatters) {
  const Workplace place;
  for (const char* seed : {"1", "2"})
    ASSERT_EQ(verdigris({"voronoi", place.cube(), "--cells", "6k", "--seeds", "5", "--seed", seed,
                         "--no-picture", "--out", place.path(seed)})
                  .status,
              0);
  EXPECT_NE(content_of(place.path("1/cells.vtp")), content_of(place.path("2/cells.vtp")));
}

}  // namespace
