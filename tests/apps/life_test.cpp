// Life-like rules from the command line.
#include <gtest/gtest.h>

#include "program.hpp"

namespace {

void expect_repeated(const Workplace& place, Arguments arguments) {
  arguments.insert(arguments.end(), {"--threads", "2", "--out", place.path("first")});
  const Outcome first = verdigris(arguments);
  ASSERT_EQ(first.status, 0) << first.err;
  const Outcome again =
      verdigris({"run", place.path("first/run.toml"), "--threads", "1", "--out", place.path("again")});
  ASSERT_EQ(again.status, 0) << again.err;
  for (const char* name : {"cells.vtp", "run.toml", "picture.png"})
    EXPECT_EQ(content_of(place.path("first") / name), content_of(place.path("again") / name)) << name;
}

TEST(Life, RunsOnAModelAndOnATorusAndIsRepeated) {
  const Workplace model, torus, bugs;
  expect_repeated(model,
                  {"life", model.cube(), "--cells", "20k", "--rule", "day & night", "--size", "320x200"});
  expect_repeated(torus,
                  {"life", "--torus", "128x192", "--rule", "23/3", "--density", "0.3", "--steps", "40"});
  expect_repeated(bugs, {"life", "--torus", "128x64", "--torus-patch", "32", "--rule",
                         "R5,C0,M1,S34..58,B34..45,NM", "--steps", "10"});
}

TEST(Life, GoesOnFromACheckpoint) {
  const Workplace place;
  const auto arguments = [&](const std::string& out) {
    return Arguments{"life",
                     "--torus",
                     "256x256",
                     "--rule",
                     "amoeba",
                     "--steps",
                     "40000",
                     "--no-picture",
                     "--out",
                     place.path(out),
                     "--checkpoint-every",
                     "50"};
  };
  ASSERT_EQ(verdigris(arguments("whole")).status, 0);
  Running running(arguments("parts"));
  while (!std::filesystem::exists(place.path("parts/checkpoint.vgc")) && !running.ended()) {
  }
  running.signal(9);
  running.wait();
  Arguments rest = arguments("parts");
  rest.push_back("--resume");
  const Outcome resumed = verdigris(rest);
  ASSERT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("resuming at step"), std::string::npos);
  EXPECT_EQ(content_of(place.path("whole/cells.vtp")), content_of(place.path("parts/cells.vtp")));
}

TEST(Life, RefusesBadInput) {
  const Workplace place;
  const auto out = place.path("out");
  const auto refused = [&](Arguments arguments, const std::string& where) {
    arguments.insert(arguments.end(), {"--out", out});
    expect_refused(verdigris(arguments), where, out);
  };
  refused({"life"}, "life");
  refused({"life", place.cube(), "--torus", "64x64"}, "life");
  refused({"life", "--torus", "64"}, "--torus");
  refused({"life", "--torus", "64x64", "--cells", "100"}, "--torus");
  refused({"life", "--torus", "64x64", "--cell-size", "3"}, "--torus");
  refused({"life", "--torus", "100x100"}, "flat torus");
  refused({"life", "--torus", "64x64", "--rule", "B3"}, "rule");
  refused({"life", "--torus", "64x64", "--rule", "R12,S1,B1"}, "rule");
  refused({"life", "--torus", "64x64", "--density", "1.5"}, "--density");
  refused({"life", "--torus", "64x64", "--density", "half"}, "--density");
  refused({"life", place.cube(), "--links", "projected"}, "links");
  const std::string scene = place.file("scene.toml", "[mesh]\ntorus = [64, 64]\nfile = \"a.obj\"\n");
  refused({"run", scene}, "scene.toml:");
  refused({"run", place.file("patch.toml", "[mesh]\nfile = \"a.obj\"\npatch = 8\n")}, "patch.toml:");
}

}  // namespace
