// Each law against its closed form, worked out by other means.

#include "verdigris/material/growth_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/material/material.hpp"

using namespace verdigris;

namespace {

constexpr ExposureClass c3 = ExposureClass::C3;

GrowthLaw law(GrowthKind kind, double rate, double exponent = 1.0) {
  GrowthLaw made;
  made.kind = kind;
  made.rate.fill(rate);
  made.exponent = exponent;
  return made;
}

TEST(GrowthLaw, LinearGrowsByTheSameEachYear) {
  const GrowthLaw linear = law(GrowthKind::linear, 1.5);
  double sum = 0.0;
  for (int year = 0; year < 40; ++year) {
    EXPECT_DOUBLE_EQ(thickness(linear, c3, year), sum);
    sum += 1.5;
  }
}

TEST(GrowthLaw, ParabolicGrowsInverselyToItsThickness) {
  // D' = r^2 / (2 D), integrated in small steps from D(1) = r.
  const GrowthLaw parabolic = law(GrowthKind::parabolic, 2.0);
  EXPECT_DOUBLE_EQ(thickness(parabolic, c3, 1.0), 2.0);
  double d = 2.0, t = 1.0;
  const double dt = 1e-4;
  for (; t < 9.0; t += dt) {
    const double half = d + 0.5 * dt * 4.0 / (2.0 * d);
    d += dt * 4.0 / (2.0 * half);
  }
  EXPECT_NEAR(thickness(parabolic, c3, t), d, 1e-6);
  EXPECT_NEAR(thickness(parabolic, c3, 9.0), 6.0, 1e-12);
}

TEST(GrowthLaw, PowerIsAStraightLineInLogarithms) {
  const GrowthLaw power = law(GrowthKind::power, 1.3, 0.667);
  for (const double t : {0.01, 0.5, 1.0, 7.0, 30.0})
    EXPECT_NEAR(std::log(thickness(power, c3, t)), std::log(1.3) + 0.667 * std::log(t), 1e-12);
}

TEST(GrowthLaw, AfterTwentyYearsItGoesOnAtItsSpeed) {
  GrowthLaw power = law(GrowthKind::power, 50.0, 0.523);
  power.steady_after = 20.0;
  const double at20 = 50.0 * std::pow(20.0, 0.523), speed = 50.0 * 0.523 * std::pow(20.0, 0.523 - 1.0);
  EXPECT_NEAR(thickness(power, c3, 20.0), at20, 1e-9);
  EXPECT_NEAR(thickness(power, c3, 50.0), at20 + 30.0 * speed, 1e-9);
  EXPECT_NEAR(thickness(power, c3, 20.001) - thickness(power, c3, 20.0), 0.001 * speed, 1e-6);
}

TEST(GrowthLaw, OnsetSaturationAndFactor) {
  GrowthLaw linear = law(GrowthKind::linear, 2.0);
  linear.delay.fill(5.0);
  linear.saturation.fill(7.0);
  EXPECT_EQ(thickness(linear, c3, -1.0), 0.0);
  EXPECT_EQ(thickness(linear, c3, 5.0), 0.0);
  EXPECT_DOUBLE_EQ(thickness(linear, c3, 6.0), 2.0);
  EXPECT_DOUBLE_EQ(thickness(linear, c3, 6.0, 0.5), 1.0);
  EXPECT_DOUBLE_EQ(thickness(linear, c3, 100.0), 7.0);
  EXPECT_DOUBLE_EQ(thickness(linear, c3, 100.0, 0.5), 7.0);
}

TEST(GrowthLaw, YearsUntilIsTheInverse) {
  for (const GrowthKind kind : {GrowthKind::linear, GrowthKind::parabolic, GrowthKind::power}) {
    GrowthLaw any = law(kind, 3.0, 0.6);
    any.delay.fill(2.0);
    any.saturation.fill(60.0);
    if (kind == GrowthKind::power) any.steady_after = 10.0;
    for (const double t : {2.5, 4.0, 11.0, 14.0}) {
      const double d = thickness(any, c3, t, 1.25);
      EXPECT_NEAR(years_until(any, c3, d, 1.25), t, 1e-9);
    }
    EXPECT_TRUE(std::isinf(years_until(any, c3, 60.1)));
    EXPECT_EQ(years_until(any, c3, 0.0), 0.0);
  }
  EXPECT_TRUE(std::isinf(years_until(law(GrowthKind::linear, 0.0), c3, 1.0)));
}

TEST(GrowthLaw, ClassesHaveTheirOwnRates) {
  GrowthLaw any = law(GrowthKind::linear, 0.0);
  any.rate = {1, 2, 3, 4, 5, 6};
  for (std::size_t k = 0; k < 6; ++k) {
    const ExposureClass exposure = exposure_class_named(exposure_class_names[k]);
    EXPECT_DOUBLE_EQ(thickness(any, exposure, 1.0), static_cast<double>(k + 1));
  }
  EXPECT_THROW(exposure_class_named("C6"), InputError);
}

TEST(Material, LayersComeAndGo) {
  Material m;
  m.thickness = 10.0;
  m.density = 8.96;
  m.loss = law(GrowthKind::linear, 1.0);
  Layer rust, paint;
  rust.growth = law(GrowthKind::linear, 3.0);
  paint.initial = 100.0;
  paint.shrinks = true;
  paint.growth = law(GrowthKind::linear, 20.0);
  m.layers = {rust, paint};
  EXPECT_EQ(stack_at(m, c3, -1.0).layers, (std::vector<double>{0.0, 100.0}));
  EXPECT_EQ(stack_at(m, c3, 2.0).layers, (std::vector<double>{6.0, 60.0}));
  EXPECT_EQ(stack_at(m, c3, 9.0).layers, (std::vector<double>{27.0, 0.0}));
  EXPECT_EQ(metal_loss(m, c3, 4.0), 4.0);
  EXPECT_EQ(metal_loss(m, c3, 40.0), 10.0);
  EXPECT_DOUBLE_EQ(metal_lifetime(m, c3), 10.0);
  // A micrometre of copper on a square metre: 1e-6 m3 of 8.96e6 g/m3.
  EXPECT_NEAR(mass_of(1.0, m.density), 8.96, 1e-12);
}

}  // namespace
