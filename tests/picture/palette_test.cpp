#include "verdigris/picture/palette.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "verdigris/picture/regions.hpp"

namespace verdigris {
namespace {

TEST(Palette, ColoursDifferAndAreAboutEquallyLight) {
  const auto palette = region_palette();
  ASSERT_GE(palette.size(), 12u);
  for (std::size_t a = 0; a < palette.size(); ++a) {
    EXPECT_GT(to_oklab(palette[a]).x, 0.54f);
    EXPECT_LT(to_oklab(palette[a]).x, 0.86f);
    for (std::size_t b = 0; b < a; ++b)
      EXPECT_GE(colour_difference(palette[a], palette[b]), 8.0f) << a << ' ' << b;
  }
}

// A triangular lattice of labels: every one has six neighbours.
std::vector<LabelPair> lattice(std::int32_t n) {
  std::vector<LabelPair> pairs;
  for (std::int32_t y = 0; y < n; ++y)
    for (std::int32_t x = 0; x < n; ++x) {
      const std::int32_t k = y * n + x;
      if (x + 1 < n) pairs.emplace_back(k, k + 1);
      if (y + 1 < n) pairs.emplace_back(k, k + n);
      if (x + 1 < n && y + 1 < n) pairs.emplace_back(k, k + n + 1);
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Palette, NeighboursDifferAndThePaletteIsUsedEvenly) {
  for (const std::int32_t n : {1, 2, 8, 316}) {
    const std::vector<LabelPair> pairs = lattice(n);
    const std::vector<Rgba8> colours = assign_colours(n * n, pairs);
    for (const auto& [a, b] : pairs)
      ASSERT_GE(colour_difference(colours[static_cast<std::size_t>(a)], colours[static_cast<std::size_t>(b)]),
                11.0f);
    std::map<std::tuple<int, int, int>, std::size_t> used;
    for (const Rgba8 c : colours) ++used[{c.r, c.g, c.b}];
    if (n < 8) continue;
    EXPECT_EQ(used.size(), region_palette().size());
    for (const auto& [colour, times] : used)
      EXPECT_LT(static_cast<double>(times), 1.0 + 1.5 * static_cast<double>(colours.size()) / 16.0);
  }
}

TEST(Palette, MoreNeighboursThanColoursIsNoError) {
  std::vector<LabelPair> pairs;
  for (std::int32_t a = 0; a < 40; ++a)
    for (std::int32_t b = a + 1; b < 40; ++b) pairs.emplace_back(a, b);
  EXPECT_EQ(assign_colours(40, pairs).size(), 40u);
  EXPECT_TRUE(assign_colours(0, {}).empty());
}

TEST(Palette, ScalarsRiseEvenlyInLightness) {
  float before = to_oklab(scalar_colour(0.0f)).x;
  for (int k = 1; k <= 20; ++k) {
    const float now = to_oklab(scalar_colour(static_cast<float>(k) / 20.0f)).x;
    EXPECT_NEAR(now - before, 0.036f, 0.012f) << k;
    before = now;
  }
  EXPECT_EQ(scalar_colour(-5.0f), scalar_colour(0.0f));
  EXPECT_EQ(scalar_colour(7.0f), scalar_colour(1.0f));
  EXPECT_EQ(scalar_colour(std::numeric_limits<float>::quiet_NaN()), unlabelled);
}

TEST(Regions, AreFoundAcrossTriangles) {
  Mesh mesh;  // a roof of two triangles: one label each
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0.5}, {0, 2, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, 400.0);
  const Surface surface = make_surface(mesh, options);
  std::vector<std::int32_t> labels(surface.slot_count(), -1);
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t s = surface.owned(row).begin; s < surface.owned(row).end; ++s)
      labels[s] = static_cast<std::int32_t>(surface.patch_of_row(row));
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) labels[target] = labels[source];
  });
  EXPECT_EQ(touching_labels(surface, labels), (std::vector<LabelPair>{{0, 1}}));

  const std::vector<Rgba8> palette = label_colours(surface, labels);
  ASSERT_EQ(palette.size(), 2u);
  const std::vector<Rgba8> plain = colour_labels(surface, labels, palette, {false, 0.5f});
  const std::vector<Rgba8> outlined = colour_labels(surface, labels, palette);
  std::size_t darker = 0;
  for (std::size_t s = 0; s < labels.size(); ++s) {
    EXPECT_EQ(plain[s], labels[s] < 0 ? unlabelled : palette[static_cast<std::size_t>(labels[s])]);
    if (outlined[s] == plain[s]) continue;
    ++darker;
    EXPECT_EQ(labels[s], 0);  // the lower side only
  }
  EXPECT_GT(darker, 10u);
}

}  // namespace
}  // namespace verdigris
