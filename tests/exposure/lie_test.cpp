#include "verdigris/exposure/lie.hpp"

#include <gtest/gtest.h>

#include "solids.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/model_colours.hpp"

using namespace verdigris;

namespace {

TEST(Lie, HeightSlopeAndFacingOfACube) {
  const Surface surface = shapes::with_cells(shapes::cube(2.0), 5'000);
  const Field<float> height = height_mask(surface, {0, 0, 5}),
                     above = height_above_origin(surface, {0, 0, 1}), slope = slope_mask(surface, {0, 0, 1}),
                     wind = facing_mask(surface, {1, 0, 1}, 2.0);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot), n = surface.frame(surface.cell(slot).patch).normal();
    ASSERT_NEAR(height[slot], p.z / 2.0, 1e-6);
    ASSERT_NEAR(above[slot], p.z, 1e-6);
    ASSERT_NEAR(slope[slot], 1.0 - n.z, 1e-6);
    const double cosine = std::max(0.0, (n.x + n.z) * std::sqrt(0.5));
    ASSERT_NEAR(wind[slot], cosine * cosine, 1e-6);
  });
}

TEST(Lie, FacingIsSmoothOnACoarseSphere) {
  const Surface surface = shapes::with_cells(shapes::round_sphere(1.0, 2), 20'000);
  const Field<float> up = facing_mask(surface, {0, 0, 1});
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const double z = glm::normalize(surface.position(slot)).z;
    ASSERT_NEAR(up[slot], std::max(0.0, z), 0.05);
  });
}

TEST(Lie, DirectionsAreReadStrictly) {
  EXPECT_EQ(parse_direction("-y", "up"), glm::dvec3(0, -1, 0));
  EXPECT_EQ(parse_direction("1, 0.5 -2", "up"), glm::dvec3(1, 0.5, -2));
  for (const char* bad : {"", "w", "0 0 0", "1 2", "1 2 3 4", "1,,2 3", "nan 0 1", "1 2 3x"})
    EXPECT_THROW(parse_direction(bad, "up"), InputError) << bad;
}

TEST(ModelColours, AreInterpolatedAndRefusedWhenThereAreNone) {
  Mesh mesh = shapes::square(1.0);
  EXPECT_THROW(colour_mask(shapes::with_cells(mesh, 100), "red"), InputError);
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      mesh.corner_color.push_back({mesh.positions[t[k]].x, mesh.positions[t[k]].y, 0.0f, 1.0f});
  const Surface surface = shapes::with_cells(mesh, 1'000);
  const Field<float> red = colour_mask(surface, "red"), alpha = colour_mask(surface, "alpha");
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    ASSERT_NEAR(red[slot], surface.position(slot).x, 1e-6);
    ASSERT_NEAR(alpha[slot], 1.0, 1e-6);
  });
  EXPECT_THROW(colour_mask(surface, "pink"), InputError);
}

TEST(ModelColours, ImagesLieByTextureCoordinates) {
  Mesh mesh = shapes::square(1.0);
  const ImageValues image{2, 2, {0.0f, 1.0f, 0.0f, 0.5f}};  // bright at the upper right
  EXPECT_THROW(image_mask(shapes::with_cells(mesh, 100), image), InputError);
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) mesh.corner_uv.push_back({mesh.positions[t[k]].x, mesh.positions[t[k]].y});
  const Surface surface = shapes::with_cells(mesh, 1'000);
  const Field<float> grey = image_mask(surface, image);
  shapes::each_cell(surface, [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    if (p.x > 0.25 && p.x < 0.75 && p.y > 0.25 && p.y < 0.75) {
      ASSERT_NEAR(grey[slot], (2.0 * p.x - 0.5) * (0.5 + 0.5 * (2.0 * p.y - 0.5)), 1e-5);
    }
  });
  EXPECT_THROW(image_mask(surface, {}), InputError);
}

}  // namespace
