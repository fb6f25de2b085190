// Masks of a scene: what drives a behaviour, and what bars growth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cells_file.hpp"
#include "grey_ramp.hpp"
#include "program.hpp"

namespace {

const std::string voronoi =
    "[mesh]\nfile = \"cube.obj\"\n[surface]\ncells = 6000\n[seeds]\ncount = 3\n[picture]\ndraw = false\n";
const std::string life =
    "[mesh]\nfile = \"cube.obj\"\n[surface]\ncells = 6000\n[behaviour]\nname = \"life\"\n[run]\nsteps = 2\n"
    "[picture]\ndraw = false\n";

TEST(Masks, OfNoiseBarGrowthWhereTheyReachTheThreshold) {
  const Workplace place;
  place.cube();
  const std::string scene =
      place.file("scene.toml", voronoi +
                                   "[barrier]\nthreshold = 0.7\n[masks.barrier]\nsource = \"cellular\"\n"
                                   "frequency = 3\ndistance = \"F2-F1\"\nlow = 1.0\nhigh = 0.0\n");
  const Outcome outcome = verdigris({"run", scene, "--out", place.path("out"), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  std::size_t empty = 0;
  for (const std::int32_t label : cells.label) empty += static_cast<std::size_t>(label == -1);
  EXPECT_GT(empty, cells.label.size() / 20);
  EXPECT_LT(empty, cells.label.size());
  // And again from what it wrote, to the bit.
  ASSERT_EQ(verdigris({"run", place.path("out/run.toml"), "--out", place.path("again")}).status, 0);
  EXPECT_TRUE(content_of(place.path("again/cells.vtp")) == content_of(place.path("out/cells.vtp")));
  EXPECT_EQ(content_of(place.path("again/run.toml")), content_of(place.path("out/run.toml")));
}

TEST(Masks, DriveTheBehaviourAndAreWrittenOut) {
  const Workplace place;
  place.cube();
  const auto run = [&](const std::string& name, const std::string& mask) {
    const Outcome outcome =
        verdigris({"run", place.file(name + ".toml", life + mask), "--out", place.path(name)});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return content_of(place.path(name + "/cells.vtp"));
  };
  const std::string plain = run("plain", ""), noise = run("noise", "[masks.alive]\nsource = \"fbm\"\n"),
                    other = run("other", "[masks.alive]\nsource = \"fbm\"\nseed = 2\n");
  EXPECT_TRUE(plain.find("mask_alive") == std::string::npos);
  EXPECT_TRUE(noise.find("Name=\"mask_alive\"") != std::string::npos);
  EXPECT_FALSE(noise == other);
}

TEST(Masks, OfFilesAreStretched) {
  const Workplace place;
  place.cube();
  place.file("heights.txt", "0\n0\n0\n0\n10\n10\n10\n10\n");
  const std::string scene = place.file(
      "scene.toml",
      voronoi + "[barrier]\nthreshold = 0.75\n[masks.barrier]\nfile = \"heights.txt\"\nhigh = 10\n");
  const Outcome outcome = verdigris({"run", scene, "--out", place.path("out")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const CellsFile cells = read_cells(place.path("out/cells.vtp"));
  float lowest = 2.0f;
  for (std::size_t k = 0; k < cells.label.size(); ++k)
    if (cells.label[k] == -1) lowest = std::min(lowest, static_cast<float>(cells.points[k].z));
  EXPECT_NEAR(lowest, 0.75, 0.05);
}

TEST(Masks, OfCatalogueAndFormulasDriveBehaviours) {
  const Workplace place;
  place.cube();
  std::string up = life;
  up.replace(up.find("draw = false"), 12, "draw = false\nup = \"z\"");
  const std::string scene = place.file(
      "scene.toml", up + "[masks]\nlift = { source = \"height\", low = 1, high = 0 }\n"
                         "alive = { formula = \"clamp(2 * lift * lift - 0.5 * (1 - facing), 0, 2)\" }\n");
  ASSERT_EQ(verdigris({"run", scene, "--out", place.path("out")}).status, 0);
  const std::vector<float> alive = floats_of(place.path("out/cells.vtp"), "mask_alive");
  EXPECT_EQ(content_of(place.path("out/cells.vtp")).find("mask_lift"), std::string::npos);
  const std::vector<glm::dvec3> points = points_of(place.path("out/cells.vtp"));
  ASSERT_EQ(alive.size(), points.size());
  for (std::size_t k = 0; k < alive.size(); ++k) {
    const double z = points[k].z, lift = 1.0 - z, facing = z > 1.0 - 1e-6 ? 1.0 : 0.0;
    ASSERT_NEAR(alive[k], std::clamp(2.0 * lift * lift - 0.5 * (1.0 - facing), 0.0, 1.0), 1e-4) << z;
  }
  ASSERT_EQ(verdigris({"run", place.path("out/run.toml"), "--out", place.path("again")}).status, 0);
  EXPECT_TRUE(content_of(place.path("again/cells.vtp")) == content_of(place.path("out/cells.vtp")));
  EXPECT_EQ(content_of(place.path("again/run.toml")), content_of(place.path("out/run.toml")));
}

// A square in the plane z = 0 whose texture coordinates are its own.
std::string square(const Workplace& place) {
  return place.file("square.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                    "f 1/1 2/2 3/3 4/4\n");
}

TEST(Masks, OfImagesLieByTextureCoordinates) {
  const Workplace place;
  square(place);
  write_grey_ramp(place.path("ramp.png"), 64, 2, 3);  // of 16 bits: darker than 1/255
  std::string flat = life;
  flat.replace(flat.find("cube"), 4, "square");
  const std::string scene = place.file("scene.toml", flat + "[masks.alive]\nimage = \"ramp.png\"\nhigh = " +
                                                         std::to_string(63 * 3 / 65535.0) + "\n");
  ASSERT_EQ(verdigris({"run", scene, "--out", place.path("out")}).status, 0);
  const std::vector<float> alive = floats_of(place.path("out/cells.vtp"), "mask_alive");
  const std::vector<glm::dvec3> points = points_of(place.path("out/cells.vtp"));
  ASSERT_EQ(alive.size(), points.size());
  for (std::size_t k = 0; k < alive.size(); ++k) {
    const double x = points[k].x;
    if (x > 1.0 / 64 && x < 63.0 / 64) {
      ASSERT_NEAR(alive[k], (64 * x - 0.5) / 63, 0.01);
    }
  }
  ASSERT_EQ(verdigris({"run", place.path("out/run.toml"), "--out", place.path("again")}).status, 0);
  EXPECT_TRUE(content_of(place.path("again/cells.vtp")) == content_of(place.path("out/cells.vtp")));
}

#ifdef VERDIGRIS_WITH_GL
TEST(Masks, AreDrawn) {
  const Workplace place;
  place.cube();
  std::string drawn = life + "width = 64\nheight = 48\n[masks.alive]\nsource = \"ridged\"\n";
  drawn.replace(drawn.find("draw = false"), 12, "draw = true");
  const Outcome outcome =
      verdigris({"run", place.file("scene.toml", drawn), "--out", place.path("out"), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::is_regular_file(place.path("out/mask_alive.png")));
  const auto files = nlohmann::json::parse(outcome.out)["files"];
  EXPECT_NE(std::find(files.begin(), files.end(), "mask_alive.png"), files.end());
}
#endif

TEST(Masks, ThatCannotBeUsedAreRefused) {
  const Workplace place;
  place.cube();
  place.file("numbers.txt", "1\n2\n3\n");
  const std::string out = place.path("out");
  const auto refused = [&](const std::string& scene, const std::string& where) {
    SCOPED_TRACE(where);
    expect_refused(verdigris({"run", place.file("scene.toml", scene), "--out", out}), where, out);
  };
  refused(voronoi + "[masks.strong]\nsource = \"fbm\"\n", "it takes only barrier");
  refused(life + "[masks.strong]\nsource = \"fbm\"\n", "it takes alive and barrier");
  refused(life + "[masks.alive]\nsource = \"moss\"\n", "moss");
  refused(life + "[masks.alive]\nsource = \"ao\"\nscale = 2\n", "has no scale");
  refused(life + "[masks.alive]\nsource = \"ao\"\nrays = 3\n", "ao.rays");
  refused(life + "[masks.alive]\nsource = \"ao\"\nlow = 1\n", "low and high are both");
  refused(life + "[masks.alive]\nformula = \"ao + moss\"\n", "scene.toml:");
  refused(life + "[masks.alive]\nformula = \"ao\"\nscale = 2\n", "scene.toml:");
  refused(life + "[masks.idle]\nsource = \"ao\"\n[masks.alive]\nformula = \"sky\"\n", "masks.idle");
  refused(life + "[masks.a]\nformula = \"b\"\n[masks.b]\nformula = \"a\"\n[masks.alive]\nformula = \"a\"\n",
          "leads back to itself");
  refused(life + "[masks.a]\nformula = \"b\"\n[masks.b]\nformula = \"a\"\n[masks.alive]\nsource = \"ao\"\n",
          "leads back to itself");
  refused(life + "[masks.idle]\nformula = \"idle\"\n", "leads back to itself");
  refused(life + "[masks.alive]\nimage = \"none.png\"\n", "none.png");
  refused(life + "[masks.alive]\nimage = \"numbers.txt\"\n", "numbers.txt");
  write_grey_ramp(place.path("grey.png"), 1, 1, 1);
  refused(life + "[masks.alive]\nimage = \"grey.png\"\n", "texture coordinates");
  refused(life + "[masks.alive]\nsource = \"fbm\"\nwidth = 3\n", "fbm.width");
  refused(life + "[masks.alive]\nsource = \"fbm\"\noctaves = 99\n", "fbm.octaves");
  refused(life + "[masks.alive]\nsource = \"fbm\"\nlow = 1\nhigh = 1.0\n", "scene.toml:");
  refused(life + "[masks.alive]\nsource = \"fbm\"\nscale = 0\n", "scene.toml:");
  refused(life + "[masks.alive]\nlow = 1\n", "scene.toml:");
  refused(life + "[masks.alive]\nsource = \"fbm\"\nfile = \"numbers.txt\"\n", "scene.toml:");
  refused(life + "[masks.alive]\nfile = \"none.txt\"\n", "none.txt");
  refused(life + "[masks.alive]\nfile = \"numbers.txt\"\n", "numbers.txt");
  refused(life + "[masks.alive]\nfile = \"numbers.txt\"\nseed = 2\n", "scene.toml:");
  refused(life + "[masks]\nalive = 1\n", "scene.toml:");
  refused(voronoi + "[barrier]\nmask = \"numbers.txt\"\n[masks.barrier]\nsource = \"fbm\"\n",
          "masks.barrier");
}

}  // namespace
