// Films: frames, video, and going on after a kill.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <ostream>
#include <random>
#include <thread>

#include "grey_levels.hpp"
#include "program.hpp"

#ifdef VERDIGRIS_WITH_GL

namespace {

namespace fs = std::filesystem;

bool no_ffmpeg() {
  return std::system("ffmpeg -version > /dev/null 2>&1") != 0;
}

const char* const weathering =
    "timeline = [\n  { op = \"coat\", thickness = 50, variation = 0.0 },\n"
    "  { op = \"scratch\", count = 4 },\n"
    "  { op = \"age\", class = \"C5\", years = 3, spread = 0.05, seeding = \"bare\" },\n]\n\n"
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 20000\n\n[picture]\nwidth = 96\nheight = 80\n\n"
    "[animation]\nframes = 24\nhold = 3\nturn = 90\noverlay = true\n"
    "camera = [ { at = 0, view = \"iso\" }, { at = 1, view = \"front\", zoom = 1.5, target = [0.5, 0.5, 1] } "
    "]\n\n"
    "[weathering]\nmaterial = \"bare-steel\"\n";

const char* const corrosion =
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 20000\n\n[behaviour]\nname = \"corrosion\"\n\n"
    "[corrosion]\nmaterial = \"copper\"\nstep_years = 0.1\n\n[run]\nsteps = 200\n\n"
    "[picture]\nwidth = 96\nheight = 80\n\n[animation]\nframes = 24\nhold = 2\noverlay = true\n";

const char* const growth =
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 20000\n\n[seeds]\ncount = 5\n\n[barrier]\nangle = "
    "80\n\n"
    "[picture]\nwidth = 96\nheight = 80\n\n[animation]\nframes = 24\nhold = 2\nturn = 30\noverlay = true\n";

const char* const life =
    "[mesh]\nfile = \"cube.obj\"\n\n[surface]\ncells = 5000\n\n[behaviour]\nname = \"life\"\n\n[run]\nsteps "
    "= 40\n\n"
    "[picture]\nwidth = 97\nheight = 81\n\n[animation]\nframes = 24\nhold = 1\noverlay = true\n";

std::map<std::string, std::string> film_in(const fs::path& out) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(out / "frames"))
    files[entry.path().filename().string()] = content_of(entry.path());
  files["video"] = content_of(out / "animation.mp4");
  return files;
}

struct Kind {
  const char *name, *scene;
};
void PrintTo(const Kind& kind, std::ostream* out) {
  *out << kind.name;
}

class Animate : public testing::TestWithParam<Kind> {
 protected:
  void SetUp() override {
    if (no_ffmpeg()) GTEST_SKIP() << "there is no ffmpeg";
    place.cube();
    scene = place.file("scene.toml", GetParam().scene);
  }
  Workplace place;
  std::string scene;
};

TEST_P(Animate, MakesTheSameFilmFromAnyNumberOfThreadsAndFromItsOwnScene) {
  const std::string out = place.path("out"), one = place.path("one"), again = place.path("again");
  const Outcome outcome = verdigris({"animate", scene, "--out", out});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto film = film_in(out);
  EXPECT_EQ(film.size(), 25u);
  EXPECT_NE(film.at("00000.png"), film.at("00023.png"));
  EXPECT_EQ(film.at("video").substr(4, 4), "ftyp");
  ASSERT_EQ(verdigris({"animate", scene, "--out", one, "--threads", "1"}).status, 0);
  EXPECT_EQ(film_in(one), film);
  ASSERT_EQ(verdigris({"animate", out + "/run.toml", "--out", again}).status, 0);
  EXPECT_EQ(film_in(again), film);
  // A shorter film leaves nothing of the longer one.
  ASSERT_EQ(verdigris({"animate", scene, "--frames", "16", "--out", again, "--no-video"}).status, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(again + "/frames"), fs::directory_iterator()), 16);
  EXPECT_FALSE(fs::exists(again + "/animation.mp4"));
}

TEST_P(Animate, GoesOnWhereItWasKilledOrStopped) {
  const std::string straight = place.path("straight"), out = place.path("out");
  ASSERT_EQ(verdigris({"animate", scene, "--out", straight}).status, 0);
  const auto frames = [&] {
    std::ptrdiff_t count = 0;
    std::error_code none_yet;
    for (fs::directory_iterator it(out + "/frames", none_yet), end; !none_yet && it != end; ++it)
      count += it->path().extension() == ".png";
    return count;
  };
  std::mt19937 random(3);
  int kills = 0;
  for (int round = 0; round < 50; ++round) {
    Arguments arguments{"animate", scene, "--out", out};
    if (fs::exists(out + "/run.toml")) arguments.emplace_back("--resume");
    Running running(arguments);
    // Five times after a few more frames, once while ffmpeg works or about then.
    const auto until = frames() + static_cast<std::ptrdiff_t>(random() % 5) + 1;
    while (kills < 6 && !running.ended() && frames() < (kills < 5 ? until : 24))
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const int how = round % 3 == 2 ? SIGINT : SIGKILL;
    if (kills < 6 && !running.ended()) running.signal(how);
    const Outcome outcome = running.wait();
    if (outcome.status == 0) break;
    ++kills;
    ASSERT_TRUE(outcome.status == 130 || outcome.status == 128 + how) << outcome.status << outcome.err;
  }
  EXPECT_GE(kills, 3);
  EXPECT_EQ(film_in(out), film_in(straight));
}

TEST_P(Animate, KeepsToTheFilmThatWasBegun) {
  const std::string out = place.path("out");
  expect_refused(verdigris({"animate", scene, "--out", out, "--resume"}), "run.toml", out);
  ASSERT_EQ(verdigris({"animate", scene, "--out", out}).status, 0);
  const Outcome other = verdigris({"animate", scene, "--frames", "30", "--out", out, "--resume"});
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("another film"), std::string::npos) << other.err;
  EXPECT_EQ(film_in(out).size(), 25u);
  // Complete: frames are kept, the video is made again; one that was changed is found out.
  fs::remove(out + "/frames/00009.png");
  const Outcome more = verdigris({"animate", scene, "--out", out, "--resume"});
  EXPECT_EQ(more.status, 0) << more.err;
  EXPECT_NE(more.out.find("24 frames, 1 of them"), std::string::npos) << more.out;
  fs::copy_file(out + "/frames/00020.png", out + "/frames/00008.png", fs::copy_options::overwrite_existing);
  fs::remove(out + "/frames/00009.png");
  const Outcome changed = verdigris({"animate", scene, "--out", out, "--resume"});
  EXPECT_EQ(changed.status, 2);
  EXPECT_NE(changed.err.find("00008.png"), std::string::npos) << changed.err;
}

INSTANTIATE_TEST_SUITE_P(Films, Animate,
                         testing::Values(Kind{"Weathering", weathering}, Kind{"Corrosion", corrosion},
                                         Kind{"Growth", growth}, Kind{"Life", life}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(AnimateScene, NoticesThatAMaterialHasChangedThoughAllFramesAreThere) {
  if (no_ffmpeg()) GTEST_SKIP() << "there is no ffmpeg";
  const Workplace place;
  place.cube();
  std::string metal = content_of(VERDIGRIS_MESHES "/../materials/copper.toml"), text = corrosion;
  place.file("metal.toml", metal);
  text.replace(text.find("\"copper\""), 8, "\"metal.toml\"");
  const std::string scene = place.file("scene.toml", text), out = place.path("out");
  ASSERT_EQ(verdigris({"animate", scene, "--out", out}).status, 0);
  const std::string video = content_of(out + "/animation.mp4");
  ASSERT_EQ(verdigris({"animate", scene, "--out", out, "--resume"}).status, 0);
  EXPECT_EQ(content_of(out + "/animation.mp4"), video);
  metal.replace(metal.find("#5b3624"), 7, "#3080f0");
  place.file("metal.toml", metal);
  const Outcome changed = verdigris({"animate", scene, "--out", out, "--resume"});
  EXPECT_EQ(changed.status, 2) << changed.err;
  EXPECT_NE(changed.err.find("00023.png"), std::string::npos) << changed.err;
}

TEST(AnimateScene, RegionsKeepTheirColours) {
  const Workplace place;
  place.cube();
  const std::string out = place.path("out");
  std::string still = growth;
  const auto set = [&](const std::string& what, const std::string& to) {
    still.replace(still.find(what), what.size(), to);
  };
  set("angle = 80", "angle = 180");
  set("count = 5", "count = 9");
  set("turn = 30\noverlay = true\n", "");
  set("cells = 20000", "cells = 600");
  set("width = 96\nheight = 80", "width = 240\nheight = 200\noutline = false");
  ASSERT_EQ(verdigris({"animate", place.file("still.toml", still), "--out", out, "--no-video"}).status, 0);
  std::vector<std::vector<std::uint16_t>> frames;
  for (int k = 0; k < 24; ++k)
    frames.push_back(grey_levels(place.path("out") / fmt::format("frames/{:05}.png", k)));
  ASSERT_EQ(frames[0].size(), 240u * 200u);
  // A place goes from bare to the colour of its region and never back, but where regions come to touch.
  std::size_t changed = 0, back = 0;
  for (std::size_t p = 0; p < frames[0].size(); ++p) {
    const int way = int{frames.back()[p]} - int{frames[0][p]};
    if (std::abs(way) < 1000) continue;
    ++changed;
    for (std::size_t k = 1; k < frames.size(); ++k)
      if (const int step = int{frames[k][p]} - int{frames[k - 1][p]};
          std::abs(step) > 1000 && step * way < 0) {
        ++back;
        break;
      }
  }
  EXPECT_GT(changed, 5000u);
  EXPECT_LT(back, changed / 10);
}

TEST(AnimateScene, RefusesWhatIsNoFilm) {
  const std::vector<Fault> faults{
      {"frames = 24", "frames = 9", "frames"},
      {"frames = 24", "frames = 24\nyears = [1]", "scene.toml:1"},
      {"frames = 24", "years = [2, 1]", "years"},
      {"frames = 24", "years = [1, 99]", "years"},
      {"at = 1, ", "at = 0, ", "scene.toml:22"},
      {"\"front\", zoom", "\"sideways\", zoom", "sideways"},
      {"zoom = 1.5", "zoom = 0", "zoom"},
      {"[0.5, 0.5, 1]", "[0.5, 0.5]", "target"},
      {"hold = 3", "holt = 3", "holt"},
      {"[weathering]\nmaterial = \"bare-steel\"", "", "scene.toml"},
  };
  expect_faults_refused("animate", weathering, faults, {"--no-video"});
  const Workplace place;
  place.cube();
  const std::string scene = place.file("scene.toml", weathering), out = place.path("out");
  for (const Arguments& more :
       {Arguments{"--years", "2,1"}, Arguments{"--years", "nan"}, Arguments{"--rate", "0"},
        Arguments{"--frames", "0"}, Arguments{"--frames", "9", "--years", "1"}}) {
    Arguments all{"animate", scene, "--out", out};
    all.insert(all.end(), more.begin(), more.end());
    expect_refused(verdigris(all), more[0], out);
  }
}

}  // namespace

#endif
