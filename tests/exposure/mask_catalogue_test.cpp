#include "verdigris/exposure/mask_catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solids.hpp"
#include "verdigris/base/error.hpp"

using namespace verdigris;

namespace {

Mesh coloured_torus() {
  Mesh mesh = shapes::torus(2.0, 1.3, 24, 12);
  mesh.corner_color.assign(3 * mesh.triangles.size(), {0.5f, 0.25f, 0.0f, 1.0f});
  return mesh;
}

ParameterValues needed(const MaskEntry& entry) {
  if (entry.name == "lines") return {{"lines", std::string("2.8 0 0, 0 2.8 0")}};
  return {};
}

TEST(MaskCatalogue, EverySourceMakesAFieldWithoutHolesOrSeams) {
  const Surface surface = shapes::with_cells(coloured_torus(), 5'000);
  const MaskCatalogue catalogue = builtin_masks();
  ExposureCache exposures(surface);
  for (const MaskEntry& entry : catalogue.entries()) {
    SCOPED_TRACE(entry.name);
    EXPECT_FALSE(entry.summary.empty());
    const Field<float> field = entry.create(exposures, needed(entry), 1);
    ASSERT_EQ(field.size(), surface.slot_count());
    float least = 1e30f, greatest = -1e30f;
    shapes::each_cell(surface, [&](std::uint32_t slot) {
      ASSERT_TRUE(std::isfinite(field[slot]));
      least = std::min(least, field[slot]);
      greatest = std::max(greatest, field[slot]);
    });
    if (entry.unit == "1") {
      EXPECT_GE(least, 0.0f);
      EXPECT_LE(greatest, entry.name == "slope" ? 2.0f : 1.0f);
    }
    if (entry.name != "colour") {
      EXPECT_LT(least, greatest);
    }
    surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
      for (const std::uint32_t target : targets) ASSERT_EQ(field[target], field[source]);
    });
  }
}

TEST(MaskCatalogue, IsReachedByNameAndTakesParameters) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 2'000);
  const Field<float> height = make_mask(surface, "height", {{"up", std::string("-z")}});
  shapes::each_cell(
      surface, [&](std::uint32_t slot) { ASSERT_NEAR(height[slot], 1.0 - surface.position(slot).z, 1e-6); });
}

TEST(ExposureCache, GivesWhatTheFunctionsGiveAndFindsItOnce) {
  const Surface surface = shapes::with_cells(shapes::torus(2.0, 0.8, 24, 12), 5'000);
  ExposureCache known(surface);
  const glm::dvec3 up(0, 0, 1);
  const RaySettings rays{.rays = 64, .seed = 7};
  const Field<float>& rain = known.rain_exposure({up, 30.0}, rays);
  EXPECT_EQ(rain, rain_exposure(surface, {up, 30.0}, rays));
  EXPECT_EQ(&known.rain_exposure({up, 30.0}, rays), &rain);
  EXPECT_NE(known.rain_exposure({up, 31.0}, rays), rain);
  EXPECT_NE(known.rain_exposure({up, 30.0}, {.rays = 64, .seed = 8}), rain);
  EXPECT_EQ(known.sky_view(up, rays), sky_view(surface, up, rays));
  EXPECT_NE(known.sky_view(up, rays), known.sky_view(-up, rays));
  const WaterPaths& straight = known.water_paths({.up = up});
  EXPECT_EQ(&known.water_paths({.up = up}), &straight);
  EXPECT_NE(&known.water_paths({.up = up, .meander = 10.0}), &straight);
  EXPECT_EQ(straight.slots, make_water_paths(surface, {.up = up}).slots);
  // A mask made after another is the same as alone.
  const MaskCatalogue catalogue = builtin_masks();
  catalogue.find("wetness").create(known, {}, 1);
  EXPECT_EQ(catalogue.find("flow").create(known, {}, 1), make_mask(surface, "flow"));
}

TEST(MaskCatalogue, RefusesWhatItDoesNotKnow) {
  const Surface surface = shapes::with_cells(shapes::cube(1.0), 600);
  EXPECT_THROW(make_mask(surface, "glow"), InputError);
  EXPECT_THROW(make_mask(surface, "ao", {{"ray", 3.0}}), InputError);
  EXPECT_THROW(make_mask(surface, "ao", {{"rays", 3.0}}), InputError);
  EXPECT_THROW(make_mask(surface, "height", {{"up", std::string("north")}}), InputError);
  EXPECT_THROW(make_mask(surface, "lines"), InputError);
  EXPECT_THROW(make_mask(surface, "colour"), InputError);
}

TEST(MaskCatalogue, IsOpenFromOutside) {
  MaskCatalogue catalogue = builtin_masks();
  catalogue.add({"none", "nothing", "1", {}, [](ExposureCache& known, const ParameterValues&, std::uint64_t) {
                   return Field<float>(known.surface().slot_count(), 0.0f);
                 }});
  EXPECT_EQ(catalogue.find("none").summary, "nothing");
  EXPECT_THROW(catalogue.add({"ao", "", "1", {}, {}}), std::invalid_argument);
}

}  // namespace
