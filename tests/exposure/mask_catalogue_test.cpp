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
  for (const MaskEntry& entry : catalogue.entries()) {
    SCOPED_TRACE(entry.name);
    EXPECT_FALSE(entry.summary.empty());
    const Field<float> field = entry.create(surface, needed(entry), 1);
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
  catalogue.add({"none", "nothing", "1", {}, [](const Surface& s, const ParameterValues&, std::uint64_t) {
                   return Field<float>(s.slot_count(), 0.0f);
                 }});
  EXPECT_EQ(catalogue.find("none").summary, "nothing");
  EXPECT_THROW(catalogue.add({"ao", "", "1", {}, {}}), std::invalid_argument);
}

}  // namespace
