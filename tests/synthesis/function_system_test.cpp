// Attractors: dimensions, distances and densities that are known.

#include "verdigris/synthesis/function_system.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <glm/geometric.hpp>

#include "boxes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

TEST(FunctionSystem, SierpinskiTriangleHasDimensionLog3OverLog2) {
  auto points = chaos_game(named_function_system("sierpinski-triangle"), 2'000'000, 1);
  // Sheared to a right angle, so that the boxes fit it; that changes no dimension.
  for (glm::dvec3& p : points) {
    p.y *= 2.0 / std::sqrt(3.0);
    p.x -= 0.5 * p.y;
  }
  const double d =
      boxes::dimension(points, {1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128, 1.0 / 256});
  RecordProperty("dimension", std::to_string(d));
  EXPECT_NEAR(d, std::log(3.0) / std::log(2.0), 0.02);
}

TEST(FunctionSystem, SierpinskiTetrahedronHasDimensionTwo) {
  const auto points = chaos_game(named_function_system("sierpinski-tetrahedron"), 2'000'000, 1);
  const double d = boxes::dimension(points, {1.0 / 4, 1.0 / 8, 1.0 / 16, 1.0 / 32, 1.0 / 64, 1.0 / 128});
  RecordProperty("dimension", std::to_string(d));
  EXPECT_NEAR(d, 2.0, 0.02);
}

TEST(FunctionSystem, MengerSpongeHasDimensionLog20OverLog3) {
  const auto points = chaos_game(named_function_system("menger-sponge"), 4'000'000, 1);
  const double d = boxes::dimension(points, {1.0 / 3, 1.0 / 9, 1.0 / 27, 1.0 / 81});
  RecordProperty("dimension", std::to_string(d));
  EXPECT_NEAR(d, std::log(20.0) / std::log(3.0), 0.02);
}

TEST(FunctionSystem, ChaosGameIsTheSameForAnyNumberOfThreads) {
  const FunctionSystem fern = named_function_system("barnsley-fern");
  const auto many = chaos_game(fern, 100'000, 9);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(chaos_game(fern, 100'000, 9), many);
  EXPECT_NE(chaos_game(fern, 100'000, 10), many);
  // The fern's known extent.
  for (const glm::dvec3& p : many) {
    EXPECT_GT(p.x, -2.2);
    EXPECT_LT(p.x, 2.7);
    EXPECT_GE(p.y, 0.0);
    EXPECT_LT(p.y, 10.0);
  }
}

TEST(FunctionSystem, BallsHoldTheAttractor) {
  for (const char* name : function_system_names()) {
    const FunctionSystem system = named_function_system(name);
    const Ball ball = attractor_ball(system);
    double farthest = 0.0;
    for (const glm::dvec3& p : chaos_game(system, 200'000, 3))
      farthest = std::max(farthest, glm::distance(p, ball.centre));
    EXPECT_LE(farthest, ball.radius) << name;
    EXPECT_GT(farthest, 0.9 * ball.radius) << name;
  }
}

TEST(FunctionSystem, DistancesAreThoseOfTheSet) {
  const AttractorDistance triangle(named_function_system("sierpinski-triangle"), 1e-4);
  EXPECT_NEAR(triangle({0.5, 0.0, 0.0}, 10), 0.0, 2e-4);
  EXPECT_NEAR(triangle({-1.0, 0.0, 0.0}, 10), 1.0, 2e-4);
  // The middle of the largest hole is as far from its edges as an inscribed circle reaches.
  EXPECT_NEAR(triangle({0.5, std::sqrt(3.0) / 6.0, 0.0}, 10), std::sqrt(3.0) / 12.0, 2e-4);
  const AttractorDistance sponge(named_function_system("menger-sponge"), 1e-3);
  EXPECT_NEAR(sponge({0.5, 0.5, 0.5}, 10), std::sqrt(2.0) / 6.0, 2e-3);
  EXPECT_NEAR(sponge({0.5, 0.5, 0.0}, 10), 1.0 / 6.0, 2e-3);
  EXPECT_NEAR(sponge({2.0, 0.0, 1.0}, 10), 1.0, 2e-3);
  EXPECT_EQ(sponge({2.0, 0.0, 1.0}, 0.5), 0.5);
  // Against brute force.
  const FunctionSystem fern = named_function_system("barnsley-fern");
  const AttractorDistance distance(fern, 1e-3);
  const auto points = chaos_game(fern, 300'000, 4);
  for (int k = 0; k < 40; ++k) {
    const glm::dvec3 p(-3.0 + 0.15 * k, 11.0 * ((k * 7) % 40) / 40.0, 0.0);
    double nearest = 1e9;
    for (const glm::dvec3& q : points) nearest = std::min(nearest, glm::distance(p, q));
    EXPECT_LE(distance(p, 100.0), nearest + 2e-3);  // the game comes rarely to some places
    EXPECT_GE(distance(p, 100.0), nearest - 0.05);
  }
}

TEST(FunctionSystem, StretchIsTheGreatestFactor) {
  EXPECT_NEAR(stretch(glm::dmat3(0.5)), 0.5, 1e-12);
  EXPECT_NEAR(stretch(glm::dmat3(0.2, 0, 0, 0, -0.7, 0, 0, 0, 0.1)), 0.7, 1e-12);
  EXPECT_NEAR(stretch(glm::dmat3(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 0)), 1.0, 1e-8);
  EXPECT_NEAR(stretch(glm::dmat3(0, 0, 0, 1, 0, 0, 0, 0, 0)), 1.0, 1e-12);
  EXPECT_EQ(stretch(glm::dmat3(0.0)), 0.0);
}

TEST(FunctionSystem, FaultsAreSaidWithTheirPlace) {
  const auto expect = [](const std::string& text, const std::string& place) {
    try {
      parse_function_system(text, "maps");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).substr(0, place.size()), place) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
  };
  expect("", "maps: there are no maps");
  expect("# nothing", "maps: there are no maps");
  expect("0.5 0 0 0.5 0", "maps:1:1: 5 numbers");
  expect("0.5 0 0 0.5 0 0\n  .5 0 x 0 0 0", "maps:2:8: ");
  expect("0.5 0 0 0.5 0 nan", "maps:1:15: ");
  expect("0.5 0 0 1.5 0 0", "maps:1:1: the map stretches");
  expect("0.5 0 0 0.5 0 0; .5 0 0 0 0 .5 0 0 0 0 .5 0", "maps:1:18: maps of the plane");
  expect("0.5 0 0 0.5 0 0 -1", "maps:1:1: weight");
  expect("0.5 0 0 0.5 1e308 0", "maps:1:1: the map moves points by 1e+308");
  expect("0.5 0 0 0 0 0.5 0 0 0 0 0.5 -1000001", "maps:1:1: the map moves points by -1000001");
  expect("1 2 3 4 5 6 7 8 9 10 11 12 13 14", "maps:1:31: too many");
  EXPECT_THROW(named_function_system("fern"), InputError);
  const auto catalogue = builtin_primitives();
  EXPECT_THROW(catalogue.find("ifs").create({{"maps", std::string("1 1")}}, 1), InputError);
  EXPECT_THROW(catalogue.find("menger-sponge").create({{"measure", std::string("density")}}, 1), InputError);
}

TEST(FunctionSystem, SetsMayBeOnePointFarAway) {
  const PrimitiveCatalogue catalogue = builtin_primitives();
  for (const char* measure : {"distance", "density"}) {
    const auto field = catalogue.find("ifs").create({{"maps", std::string("0.998 0.01 -0.01 0.998 1e6 -7e5")},
                                                     {"measure", std::string(measure)},
                                                     {"samples", 1e4}},
                                                    1);
    const Window window = field->window();
    const glm::dvec3 middle = 0.5 * (window.lower + window.upper);
    EXPECT_NEAR(field->at({middle, 0.0}), 1.0, 0.05) << measure;
  }
}

TEST(FunctionSystem, SearchesAmongOverlappingImagesEnd) {
  // At each of some 400 levels all three images hold nearly all of the set.
  const AttractorDistance distance(
      parse_function_system("0.98 0 0 0.98 0 0; 0.98 0 0 0.98 0.02 0; 0.98 0 0 0.98 0 0.02", "maps"), 4e-4);
  // The set is the triangle of the fixed points (0, 0), (1, 0), (0, 1).
  EXPECT_NEAR(distance({0.3, 0.3, 0.0}, 10.0), 0.0, 0.02);
  EXPECT_NEAR(distance({0.3, -0.5, 0.0}, 10.0), 0.5, 0.02);
  EXPECT_NEAR(distance({1.0, 1.0, 0.0}, 10.0), std::sqrt(0.5), 0.02);
}

TEST(FunctionSystem, FieldsAreOneOnTheSet) {
  for (const char* name : {"sierpinski-triangle", "sierpinski-tetrahedron", "menger-sponge"}) {
    const auto field = builtin_primitives().find(name).create({}, 1);
    for (const glm::dvec3& p : chaos_game(named_function_system(name), 200, 5))
      EXPECT_GT(field->at({p, 0.0}), 0.9) << name;
    EXPECT_EQ(field->at({3.0, 3.0, 3.0, 0.0}), 0.0f);
  }
}

}  // namespace
}  // namespace verdigris
