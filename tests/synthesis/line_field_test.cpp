// The field of an L-system's lines is 1 on them and falls off as the distance.

#include <gtest/gtest.h>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

TEST(LineField, IsOneMinusTheDistanceOverTheFalloff) {
  // One step along y: from (0.5, 0.1) to (0.5, 0.9), a margin of 0.1 around.
  const auto field = builtin_primitives().find("lsystem").create(
      {{"grammar", std::string("axiom = F\n")}, {"falloff", 0.1}}, 1);
  EXPECT_FLOAT_EQ(field->at({0.5, 0.5, 0, 0}), 1.0f);
  EXPECT_FLOAT_EQ(field->at({0.55, 0.3, 7.0, 0}), 0.5f);
  EXPECT_FLOAT_EQ(field->at({0.5, 0.975, 0, 0}), 0.25f);
  EXPECT_FLOAT_EQ(field->at({0.61, 0.5, 0, 0}), 0.0f);
  EXPECT_FLOAT_EQ(field->at({-5.0, 9.0, 0, 0}), 0.0f);
}

TEST(LineField, InSpaceToo) {
  const auto field = builtin_primitives().find("lsystem").create(
      {{"grammar", std::string("axiom = F&F\nangle = 90\n")}, {"falloff", 0.1}}, 1);
  EXPECT_FLOAT_EQ(field->at({0.5, 0.5, 0.9, 0}), 1.0f);
  EXPECT_FLOAT_EQ(field->at({0.5, 0.9, 0.5, 0}), 1.0f);
  EXPECT_FLOAT_EQ(field->at({0.55, 0.5, 0.9, 0}), 0.5f);
  EXPECT_FLOAT_EQ(field->at({0.5, 0.5, 0.5, 0}), 0.0f);
}

TEST(LineField, RefusesBadGrammarsAndTooLongWords) {
  const auto catalogue = builtin_primitives();
  const PrimitiveEntry& entry = catalogue.find("lsystem");
  EXPECT_THROW(entry.create({{"grammar", std::string("axiom = F[\n")}}, 1), InputError);
  EXPECT_THROW(entry.create({{"preset", std::string("oak")}}, 1), InputError);
  EXPECT_THROW(entry.create({{"grammar", std::string("axiom = F(1e300)F(1e300)\nstep = 1e9\n")}}, 1),
               InputError);
  EXPECT_THROW(entry.create({{"grammar", std::string("axiom = F(1e-300)\nstep = 1e-9\n")}}, 1), InputError);
  EXPECT_THROW(entry.create({{"preset", std::string("koch-curve")}, {"iterations", 100.0}}, 1), InputError);
}

}  // namespace
}  // namespace verdigris
