// Runs that are killed, stopped, and taken up again.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <thread>

#include "program.hpp"
#include "restart_step.hpp"

namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Arguments with(Arguments arguments, const Arguments& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// A torus, and far from it a triangle whose seed is the fastest: growth on the torus then takes hundreds of
// steps a cell.
std::string torus_and_triangle(const Workplace& place) {
  constexpr int columns = 60, rows = 30;
  std::string text = "v 9 0 0\nv 9.5 0 0\nv 9 0.5 0\nf 1 2 3\n";
  const auto number = [](double x) { return std::to_string(x) + ' '; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double a = 2.0 * std::numbers::pi * i / columns, b = 2.0 * std::numbers::pi * j / rows,
                   r = 3.0 + std::cos(b);
      text += "v " + number(r * std::cos(a)) + number(r * std::sin(a)) + number(std::sin(b)) + '\n';
    }
  const auto id = [](int i, int j) { return std::to_string(4 + j % rows * columns + i % columns) + ' '; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      text += "f " + id(i, j) + id(i + 1, j) + id(i + 1, j + 1) + id(i, j + 1) + '\n';
  return place.file("torus.obj", text);
}

// Kills the run again and again at random moments until it is complete. Returns how often.
int kill_until_complete(const Arguments& arguments, const fs::path& out, double start, double all,
                        std::mt19937& random) {
  const fs::path file = out / "checkpoint.vgc";
  std::uint64_t step = 0;  // of the last checkpoint
  for (int kills = 0;; ++kills) {
    const bool resume = fs::exists(file);
    Running running(resume ? with(arguments, {"--resume"}) : arguments);
    // Anywhere from the first moment on; the share of the work that one sitting may do leaves some for tens
    // of others.
    std::uniform_real_distribution<double> moment(0.0, start + 0.08 * all);
    for (const auto until = Clock::now() + std::chrono::duration<double>(moment(random));
         Clock::now() < until;)
      std::this_thread::sleep_for(1ms);
    const bool complete = running.ended();
    if (!complete) running.signal(SIGKILL);
    const Outcome outcome = running.wait();
    const std::string resuming = "resuming at step ";
    if (const auto at = outcome.err.find(resuming); at != std::string::npos) {
      EXPECT_TRUE(resume);
      EXPECT_EQ(std::stoull(outcome.err.substr(at + resuming.size())), step) << outcome.err;
    }
    if (complete || outcome.status == 0) {
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      return kills;
    }
    EXPECT_EQ(outcome.status, 128 + SIGKILL) << outcome.err;
    if (!fs::exists(file)) {
      // Complete, but killed before it could say so.
      if (step > 0) return kills + 1;
      continue;
    }
    const auto now = checkpoint_step(file);
    EXPECT_GE(now, step);
    step = now;
    if (testing::Test::HasFailure() || kills > 1000) return -1;
  }
}

TEST(LongRestart, KilledAtRandomMomentsNothingIsLost) {
  const Workplace place;
  const std::string model = torus_and_triangle(place);
  const std::string seeds =
      place.file("seeds.txt", "9.1 0.1 0 1\n4 0 0 0.003\n-2 0.1 0 0.0021\n0 -3 1 0.0017\n");
  std::mt19937 random(20);
  int kills = 0;
  for (const char* links : {"unfolded", "projected"})
    for (int round = 0; round == 0 || kills < (links[0] == 'u' ? 30 : 60); ++round) {
      SCOPED_TRACE(links);
      ASSERT_LT(round, 20);
      const Arguments run{"voronoi",     model,     "--cells", "150k",   "--seeds",
                          seeds,         "--links", links,     "--seed", std::to_string(round),
                          "--no-picture"};
      const fs::path straight = place.path("straight"), killed = place.path("killed");
      const auto timed = [&](const Arguments& more) {
        const auto begin = Clock::now();
        const Outcome outcome = verdigris(with(run, with(more, {"--out", straight})));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return seconds_since(begin);
      };
      const double start = timed({"--steps", "1"}), all = timed({});
      const int here = kill_until_complete(with(run, {"--checkpoint-every", "1500", "--out", killed}), killed,
                                           start, all, random);
      ASSERT_GE(here, 0);
      kills += here;
      for (const char* file : {"cells.vtp", "regions.csv", "curve.csv", "run.toml"})
        EXPECT_EQ(content_of(straight / file), content_of(killed / file)) << file;
      // No checkpoint; what kills left half written is gone but for the last one's.
      EXPECT_LE(std::distance(fs::directory_iterator(killed), fs::directory_iterator()), 5);
      EXPECT_FALSE(fs::exists(killed / "checkpoint.vgc"));
      fs::remove_all(killed);
    }
  EXPECT_GE(kills, 60);
  RecordProperty("kills", kills);
  std::printf("%d kills\n", kills);
}

// A run that takes long: each seed has a face of the cube to itself, and the second spreads once in 10^4
// steps.
class Restart : public testing::Test {
 protected:
  Outcome stop(const Arguments& arguments, int signal, bool wait_for_checkpoint) const {
    Running running(arguments);
    for (int wait = 0; wait < 3000 && !fs::exists(wait_for_checkpoint ? file_ : fs::path(out_)); ++wait)
      std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(200ms);
    EXPECT_FALSE(running.ended());
    running.signal(signal);
    return running.wait();
  }
  std::uint64_t step() const { return checkpoint_step(file_); }
  void expect_not_resumed(const Arguments& arguments, const std::string& why) const {
    SCOPED_TRACE(why);
    const std::string before = content_of(file_);
    const Outcome outcome = verdigris(with(arguments, {"--resume", "--out", out_}));
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find("checkpoint.vgc: "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("remedy: "), std::string::npos) << outcome.err;
    EXPECT_EQ(content_of(file_), before);
  }

  Workplace place_;
  const std::string model_ = place_.cube();
  const std::string seeds_ = place_.file("seeds.txt", "0.5 0.5 1\n0.5 0.5 0 1e-4\n");
  const std::string out_ = place_.path("out");
  const fs::path file_ = place_.path("out") / "checkpoint.vgc";
  const Arguments base_{"voronoi", model_, "--cells", "600000", "--barrier-angle", "45", "--no-picture"};
  const Arguments run_ = with(base_, {"--seeds", seeds_});
};

TEST_F(Restart, StoppedRunsLeaveACheckpointAndResultsThatGoOn) {
  const auto end_at = [&](std::uint64_t steps) { return Arguments{"--steps", std::to_string(steps)}; };
  Outcome outcome = stop(with(run_, {"--out", out_}), SIGTERM, false);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("--resume"), std::string::npos) << outcome.err;
  const std::uint64_t first = step();
  EXPECT_TRUE(fs::exists(place_.path("out") / "cells.vtp"));

  // Again and again, and with another number of threads.
  outcome = stop(with(run_, {"--out", out_, "--resume", "--threads", "1"}), SIGINT, false);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("resuming at step " + std::to_string(first)), std::string::npos) << outcome.err;
  const std::uint64_t second = step();
  EXPECT_GT(second, first);
  EXPECT_NE(outcome.err.find("stopped after step " + std::to_string(second)), std::string::npos)
      << outcome.err;

  // The scene of a stopped run ends where it was stopped: nothing is left to do, and nothing is taken away.
  expect_not_resumed({"run", place_.path("out/run.toml")}, "to end at step " + std::to_string(second));
  expect_not_resumed(with(run_, end_at(1)), "to end at step 1");

  outcome = verdigris(with(run_, with(end_at(second + 1000), {"--out", out_, "--resume", "--json"})));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["first_step"], second);
  EXPECT_EQ(report["steps"], second + 1000);
  EXPECT_FALSE(fs::exists(file_));
  const std::string straight = place_.path("straight");
  EXPECT_EQ(verdigris(with(run_, with(end_at(second + 1000), {"--out", straight}))).status, 0);
  for (const char* name : {"cells.vtp", "regions.csv", "curve.csv", "run.toml"})
    EXPECT_EQ(content_of(place_.path("out") / name), content_of(place_.path("straight") / name)) << name;
}

TEST_F(Restart, ScenesGoOnToo) {
  EXPECT_EQ(verdigris(with(run_, {"--steps", "1", "--out", place_.path("scene")})).status, 0);
  std::string scene = content_of(place_.path("scene/run.toml"));
  scene.replace(scene.find("steps = 1"), 9, "steps = 0");
  const std::string file = place_.file("scene/long.toml", scene);
  EXPECT_EQ(stop({"run", file, "--out", out_}, SIGTERM, false).status, 130);
  const std::uint64_t first = step();
  EXPECT_EQ(stop({"run", file, "--out", out_, "--resume"}, SIGTERM, false).status, 130);
  EXPECT_GT(step(), first);
  // The options that the scene says in other words.
  EXPECT_EQ(stop(with(run_, {"--out", out_, "--resume"}), SIGTERM, false).status, 130);
}

TEST_F(Restart, CheckpointsComeByStepsAndByTime) {
  for (const char* every : {"10000", "0.05s"}) {
    SCOPED_TRACE(every);
    const Outcome outcome = stop(with(run_, {"--checkpoint-every", every, "--out", out_}), SIGKILL, true);
    EXPECT_EQ(outcome.status, 128 + SIGKILL);
    EXPECT_GT(step(), 0u);
    if (every[0] == '1') {
      EXPECT_EQ(step() % 10000, 0u);
    }
    fs::remove_all(out_);
  }
  for (const char* every :
       {"0", "-5", "1.5", "5 m", "10d", "s", "nan", "infs", "1e400s", "0s", "-1m", "many", "5mm"}) {
    SCOPED_TRACE(every);
    expect_refused(verdigris(with(run_, {"--checkpoint-every", every, "--out", out_})), "--checkpoint-every",
                   out_);
  }
}

TEST_F(Restart, OtherRunsAreRefused) {
  stop(with(run_, {"--out", out_}), SIGTERM, false);
  const auto other = [&](const Arguments& more) { return with(run_, more); };
  expect_not_resumed(other({"--seed", "2"}), "seed of the random numbers was 1, now 2");
  expect_not_resumed(other({"--corner", "0.25"}), "parameter corner was 0.2071067811865476, now 0.25");
  expect_not_resumed(other({"--links", "projected"}), "links was unfolded, now projected");
  const auto with_surface = [&](const char* model, const char* cells, const char* angle) {
    return Arguments{"voronoi", model,          "--cells", cells, "--barrier-angle",
                     angle,     "--no-picture", "--seeds", seeds_};
  };
  expect_not_resumed(with_surface(model_.c_str(), "600000", "46"), "barrier angle was 45, now 46");
  expect_not_resumed(with_surface(model_.c_str(), "600001", "45"), "cell size was ");
  const std::string winged = place_.file("winged.obj", content_of(model_) + "v 5 5 5\nf 1 2 9\n");
  expect_not_resumed(with_surface(winged.c_str(), "600000", "45"), "mesh hash was ");
  expect_not_resumed(other({"--mend"}), "mend was false, now true");
  expect_not_resumed(with(base_, {"--seeds", place_.file("seeds2.txt", "0.5 0.5 1\n0.5 0.5 0 2e-4\n")}),
                     "seeds was 2");
  expect_not_resumed(other({"--barrier-mask", place_.file("mask.txt", "0\n0\n0\n0\n0\n1\n")}),
                     "barrier was none");
}

TEST_F(Restart, WhatIsNoCheckpointIsRefused) {
  // Nothing there, and nothing made.
  expect_refused(verdigris(with(run_, {"--resume", "--out", out_})), "there is no checkpoint", out_);
  stop(with(run_, {"--out", out_}), SIGTERM, false);
  const std::string good = content_of(file_);
  const auto put = [&](const std::string& bytes) { place_.file("out/checkpoint.vgc", bytes); };
  put(good.substr(0, good.size() / 2));
  expect_not_resumed(run_, "the file is damaged");
  std::string flipped = good;
  flipped[good.size() / 2] ^= 4;
  put(flipped);
  expect_not_resumed(run_, "the file is damaged: its checksum");
  put(content_of(model_));
  expect_not_resumed(run_, "this is no verdigris checkpoint");
  put("");
  expect_not_resumed(run_, "this is no verdigris checkpoint");
}

TEST_F(Restart, WhatKilledRunsLeftHalfWrittenIsRemoved) {
  fs::create_directory(out_);
  const std::string mine = "checkpoint.vgc." + std::to_string(::getpid()) + ".part";
  const std::vector<std::string> kept{mine, "notes.part", "checkpoint.vgc.part", "checkpoint.vgc.12x.part",
                                      "other.99999999.part"};
  for (const std::string& name : kept) place_.file("out/" + name, "kept");
  for (const char* name : {"checkpoint.vgc.99999999.part", "cells.vtp.99999998.part"})
    place_.file(std::string("out/") + name, "gone");
  EXPECT_EQ(verdigris(with(run_, {"--steps", "3", "--out", out_})).status, 0);
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(fs::path(out_) / name)) << name;
  EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(out_), fs::directory_iterator())),
            kept.size() + 4);
}

}  // namespace
