// verdigris synth: heights, land, and fields on models.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

TEST(Synth, WritesSixteenBitHeightsOfEveryPrimitive) {
  const Workplace place;
  const Outcome list = verdigris({"list", "--json"});
  ASSERT_EQ(list.status, 0);
  const auto primitives = nlohmann::json::parse(list.out)["primitives"];
  ASSERT_GE(primitives.size(), 10u);
  for (const auto& primitive : primitives) {
    const std::string name = primitive["name"], file = place.path(name + ".png");
    const Outcome outcome = verdigris({"synth", name, "--size", "32x16", "--out", file, "--json"});
    ASSERT_EQ(outcome.status, 0) << name << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["samples"], 512) << name;
    const std::string png = content_of(file);
    ASSERT_GT(png.size(), 33u);
    EXPECT_EQ(big_endian(png, 16), 32u);
    EXPECT_EQ(big_endian(png, 20), 16u);
    EXPECT_EQ(png[24], 16) << "bits";
    EXPECT_EQ(png[25], 0) << "grey";
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
  refused({"fbm", "--size", "0"}, "size");
  refused({"fbm", "--size", "12y"}, "size");
  refused({"fbm", "--low", "1", "--high", "1"}, "low");
  refused({"fbm", "--low", "nan"}, "low");
  refused({"fbm", "--size", "1", "--mesh", place.path("land.obj")}, "size");
  refused({"fbm", "--size", "8", "--mesh", place.path("land.doc")}, "land.doc");
  refused({"fbm", "--on", cube, "--view", "sideways"}, "view");
  refused({"fbm", "--on", place.path("none.obj")}, "none.obj");
  EXPECT_EQ(verdigris({"synth"}).status, 2);
  EXPECT_EQ(verdigris({"synth", "moss"}).status, 2);
  EXPECT_EQ(verdigris({"synth", "fbm", "--on", cube, "--out", place.path("a.txt")}).status, 2);
}

}  // namespace
