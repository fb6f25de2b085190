// The materials of the library, and files that are none.

#include <gtest/gtest.h>

#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/io/read_material.hpp"

using namespace verdigris;

namespace {

TEST(MaterialFiles, AreBuiltInAndWhole) {
  EXPECT_EQ(material_names(), (std::vector<std::string>{"bare-steel", "bronze", "copper", "steel", "zinc"}));
  for (const std::string& name : material_names()) {
    SCOPED_TRACE(name);
    const Material built_in = find_material(name);
    EXPECT_EQ(built_in.name, name);
    EXPECT_FALSE(built_in.summary.empty());
    EXPECT_FALSE(built_in.layers.empty());
    const Material file = find_material(std::string(VERDIGRIS_MATERIALS "/") + name + ".toml");
    EXPECT_EQ(file.layers.size(), built_in.layers.size());
    EXPECT_EQ(file.metal.colour, built_in.metal.colour);
    // Harsher air never corrodes less.
    for (std::size_t k = 0; k + 1 < 6; ++k)
      for (const double years : {0.5, 5.0, 30.0})
        EXPECT_LE(metal_loss(built_in, static_cast<ExposureClass>(k), years),
                  metal_loss(built_in, static_cast<ExposureClass>(k + 1), years));
  }
}

// ISO 9223:2012, table 2 (upper bounds) and ISO 9224:2012, table 2.
TEST(MaterialFiles, HoldTheFiguresOfTheStandards) {
  const auto expect = [](const char* name, const PerClass& first_year, double b) {
    const Material material = find_material(name);
    EXPECT_EQ(material.loss.rate, first_year) << name;
    EXPECT_EQ(material.loss.kind, GrowthKind::power);
    EXPECT_EQ(material.loss.exponent, b) << name;
    EXPECT_EQ(material.loss.steady_after, 20.0);
  };
  expect("bare-steel", {1.3, 25, 50, 80, 200, 700}, 0.523);
  expect("steel", {1.3, 25, 50, 80, 200, 700}, 0.523);
  expect("zinc", {0.1, 0.7, 2.1, 4.2, 8.4, 25}, 0.813);
  expect("copper", {0.1, 0.6, 1.3, 2.8, 5.6, 10}, 0.667);
}

TEST(MaterialFiles, CopperIsBrownFirstAndGreenLater) {
  const Material copper = find_material("copper");
  ASSERT_EQ(copper.layers.size(), 2u);
  EXPECT_EQ(copper.layers[0].name, "cuprite");
  for (const ExposureClass c : {ExposureClass::C3, ExposureClass::C4, ExposureClass::C5}) {
    const auto young = stack_at(copper, c, 2.0).layers, old = stack_at(copper, c, 40.0).layers;
    EXPECT_GT(young[0], 0.5);
    EXPECT_EQ(young[1], 0.0);
    EXPECT_GT(old[1], 2.0 * old[0]);
  }
  const auto arid = stack_at(copper, ExposureClass::C1, 200.0).layers;
  EXPECT_EQ(arid[1], 0.0);
  const auto sound = stack_at(copper, ExposureClass::C3, -1.0);
  EXPECT_EQ(sound.layers, (std::vector<double>{0.0, 0.0}));
  EXPECT_EQ(sound.metal_lost, 0.0);
}

const std::string good = R"(name = "x"
summary = "y"
[metal]
colour = "#808080"
roughness = 0.5
specular = 0.5
shininess = 10
density = 8
thickness = 100
loss = { law = "linear", rate = 1 }
[[layer]]
name = "skin"
colour = "#102030"
roughness = 0.5
specular = 0.5
shininess = 10
density = 4
opacity = 0.5
growth = { law = "power", rate = [1, 2, 3, 4, 5, 6], exponent = 0.5 }
)";

TEST(MaterialFiles, SayWhereTheyAreWrong) {
  const Material material = parse_material(good, "file");
  EXPECT_EQ(material.loss.rate[5], 1.0);
  EXPECT_EQ(material.layers.at(0).growth.rate[5], 6.0);
  EXPECT_NEAR(material.layers[0].finish.colour.z, 48.0 / 255.0, 1e-6);

  const auto refused = [](const std::string& from, const std::string& to, const std::string& line,
                          const std::string& why) {
    std::string text = good;
    const auto at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, from.size(), to);
    try {
      parse_material(text, "file");
      ADD_FAILURE() << "taken, though " << why;
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "file:" + line) << error.what();
      EXPECT_NE(error.problem().find(why), std::string::npos) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
  };
  refused("density = 8", "density = \"8\"", "8", "density is not a number");
  refused("density = 8", "density = -1", "8", "density is not a number");
  refused("density = 8", "density = nan", "8", "density is not a number");
  refused("density = 8\n", "", "3", "has no 'density'");
  refused("density = 8", "densty = 8", "8", "has no key 'densty'");
  refused("\"#808080\"", "\"grey\"", "4", "is not a colour");
  refused("\"linear\"", "\"cubic\"", "10", "there is no law 'cubic'");
  refused("rate = 1 }", "rate = 1, exponent = 1 }", "10", "a linear law has no exponent");
  refused("[1, 2, 3, 4, 5, 6]", "[1, 2, 3]", "19", "has 3 numbers");
  refused("opacity = 0.5", "opacity = 1.0", "18", "opacity is not a number");
  refused("[[layer]]", "[layer]", "11", "is not a list of tables");
  refused("name = \"x\"", "name = x", "1", "");
  EXPECT_THROW(find_material("unobtainium"), InputError);
  EXPECT_THROW(find_material("not/there.toml"), InputError);
}

}  // namespace
