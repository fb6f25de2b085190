// verdigris synth: heights, land, and fields on models.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "fbm_heights.hpp"
#include "grey_levels.hpp"
#include "program.hpp"

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

std::size_t count_of_levels(const std::filesystem::path& file) {
  const auto levels = grey_levels(file);
  return std::set(levels.begin(), levels.end()).size();
}

TEST(Synth, DrawsTheHeightsThatTheLibrarySamples) {
  const Workplace place;
  const std::string file = place.path("fbm.png");
  ASSERT_EQ(verdigris({"synth", "fbm", "--seed", "5", "--h", "0.6", "--section", "0.25", "--size", "40x24",
                       "--low", "-0.5", "--high", "1", "--threads", "1", "--out", file})
                .status,
            0);
  const auto levels = grey_levels(file);
  const std::vector<float> values = fbm_heights(0.6, 5, 40, 24, 0.25);
  ASSERT_EQ(levels.size(), values.size());
  for (std::size_t k = 0; k < levels.size(); ++k)
    ASSERT_NEAR(levels[k] / 65535.0, std::clamp((values[k] + 0.5f) / 1.5f, 0.0f, 1.0f), 1e-4) << k;
}

TEST(Synth, SaysWhatIsBlackAndWhite) {
  const Workplace place;
  const Outcome outcome = verdigris(
      {"synth", "fbm", "--size", "32", "--low", "-0.01", "--high", "0.01", "--out", place.path("fbm.png")});
  EXPECT_NE(outcome.out.find("; drawn from -0.01 (black) to 0.01 (white); "), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find(" % beyond\n"), std::string::npos) << outcome.out;
}

TEST(Synth, WritesSixteenBitHeightsOfEveryPrimitive) {
  const Workplace place;
  const Outcome list = verdigris({"list", "--json"});
  ASSERT_EQ(list.status, 0);
  const auto primitives = nlohmann::json::parse(list.out)["primitives"];
  ASSERT_GE(primitives.size(), 10u);
  for (const auto& primitive : primitives) {
    const std::string name = primitive["name"], file = place.path(name + ".png");
    const Outcome outcome = verdigris({"synth", name, "--size", "64x48", "--out", file, "--json"});
    ASSERT_EQ(outcome.status, 0) << name << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["samples"], 64 * 48) << name;
    const std::string png = content_of(file);
    ASSERT_GT(png.size(), 33u);
    EXPECT_EQ(big_endian(png, 16), 64u);
    EXPECT_EQ(big_endian(png, 20), 48u);
    EXPECT_EQ(png[24], 16) << "bits";
    EXPECT_EQ(png[25], 0) << "grey";
    EXPECT_GE(count_of_levels(file), 2u) << name;
  }
}

TEST(Synth, RepeatsItselfAndHeedsTheSeed) {
  const Workplace place;
  for (const auto& [file, seed] : {std::pair("a.png", "5"), std::pair("b.png", "5"), std::pair("c.png", "6")})
    ASSERT_EQ(
        verdigris({"synth", "hybrid", "--size", "64", "--seed", seed, "--out", place.path(file)}).status, 0);
  EXPECT_EQ(content_of(place.path("a.png")), content_of(place.path("b.png")));
  EXPECT_NE(content_of(place.path("a.png")), content_of(place.path("c.png")));
}

TEST(Synth, WritesLandThatIsClosedWhenSolid) {
  const Workplace place;
  const std::string land = place.path("land.ply");
  ASSERT_EQ(verdigris({"synth", "ridged", "--size", "33", "--mesh", land, "--solid"}).status, 0);
  const auto report = nlohmann::json::parse(verdigris({"info", land, "--json"}).out);
  EXPECT_EQ(report["closed"], true);
  EXPECT_EQ(report["triangles"], 2 * 32 * 32 + 3 * 4 * 32);
  EXPECT_EQ(report["inconsistent_edges"], 0);
}

TEST(Synth, LaysFieldsOnModels) {
  const Workplace place;
  const std::string cells = place.path("noise.vtp");
  const Outcome outcome =
      verdigris({"synth", "fbm", "--on", place.cube(), "--cells", "6k", "--out", cells, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(content_of(cells).find("Name=\"fbm\""), std::string::npos);
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_LT(report["least"], -0.05);
  EXPECT_GT(report["greatest"], 0.05);
#ifdef VERDIGRIS_WITH_GL
  const std::string picture = place.path("noise.png");
  const Outcome drawn = verdigris({"synth", "fbm", "--on", place.cube(), "--cells", "6k", "--size", "160x120",
                                   "--view", "front", "--out", picture});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  EXPECT_GE(count_of_levels(picture), 20u);
#endif
}

TEST(Synth, DrawsShadedMapsAndOtherSections) {
  const Workplace place;
  const auto draw = [&](const std::string& file, Arguments more) {
    more.insert(more.begin(), {"synth", "fbm", "--size", "32", "--out", place.path(file)});
    EXPECT_EQ(verdigris(more).status, 0);
    return content_of(place.path(file));
  };
  const std::string plain = draw("plain.png", {}), shaded = draw("shaded.png", {"--shaded"});
  EXPECT_EQ(shaded[25], 2) << "in colour";
  EXPECT_GE(count_of_levels(place.path("shaded.png")), 20u);
  EXPECT_NE(draw("flat.png", {"--shaded", "--relief", "0"}), shaded);
  EXPECT_NE(draw("section.png", {"--section", "0.3"}), plain);
}

TEST(Synth, RefusesWhatItCannotUse) {
  const Workplace place;
  const std::string out = place.path("out.png"), cube = place.cube();
  const auto refused = [&](std::vector<std::string> arguments, const std::string& where) {
    SCOPED_TRACE(where);
    arguments.insert(arguments.begin(), "synth");
    arguments.insert(arguments.end(), {"--out", out});
    expect_refused(verdigris(arguments), where, out);
  };
  refused({"fbm", "--octaves", "2.5"}, "octaves");
  refused({"fbm", "--octaves", "many"}, "octaves");
  refused({"fbm", "--basis", "wool"}, "basis");
  refused({"fbm", "--period", "0.1", "--frequency", "1"}, "period");
  refused({"fbm", "--size", "0"}, "'0' is neither N nor WxH");
  refused({"fbm", "--size", "12y"}, "size");
  refused({"fbm", "--low", "1", "--high", "1"}, "low");
  refused({"fbm", "--low", "nan"}, "low");
  refused({"fbm", "--low", "0", "--high", "1e-40"}, "--low, --high");
  refused({"fbm", "--low", "1e300"}, "--low");
  refused({"ifs", "--maps", "0.5 0 0 0.5 1e308 0", "--measure", "density"}, "ifs.maps:1:1");
  refused({"lsystem", "--grammar", "axiom = F(1e300)F(1e300)\nstep = 1e9"}, "turtle");
  refused({"fbm", "--size", "1", "--mesh", place.path("land.obj")}, "size");
  refused({"fbm", "--size", "8", "--mesh", place.path("land.doc")}, "land.doc");
  refused({"fbm", "--solid"}, "--solid");
  refused({"fbm", "--relief", "0.3"}, "--relief");
  for (const char* option : {"--cells", "--cell-size", "--links", "--view", "--up", "--scale"})
    refused({"fbm", option, "1"}, option);
  refused({"fbm", "--mend"}, "--mend");
  refused({"fbm", "--on", cube, "--shaded"}, "--shaded");
  refused({"fbm", "--on", cube, "--section", "0.5"}, "--section");
  refused({"fbm", "--on", cube, "--relief", "0.5"}, "--relief");
  refused({"fbm", "--on", cube, "--mesh", place.path("land.obj")}, "--mesh");
  refused({"fbm", "--threads", "0"}, "--threads");
  refused({"fbm", "--on", cube, "--view", "sideways"}, "view");
  refused({"fbm", "--on", place.path("none.obj")}, "none.obj");
  EXPECT_EQ(verdigris({"synth"}).status, 2);
  EXPECT_EQ(verdigris({"synth", "moss"}).status, 2);
  EXPECT_EQ(verdigris({"synth", "fbm", "--on", cube, "--out", place.path("a.txt")}).status, 2);
  expect_refused(verdigris({"synth", "fbm", "--out", place.path("a.jpg")}), ".jpg", place.path("a.jpg"));
}

}  // namespace
