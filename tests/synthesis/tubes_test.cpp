// Tubes are solids: every edge has two faces, and the volume is that of a round tube.

#include "verdigris/synthesis/tubes.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numbers>

#include "verdigris/base/error.hpp"
#include "verdigris/mesh/report.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {
namespace {

void expect_sound(const Mesh& mesh) {
  // Welded as a reader would.
  const Mesh welded = weld(mesh);
  EXPECT_EQ(welded.positions.size(), mesh.positions.size());
  const MeshReport report = inspect(welded, make_adjacency(welded));
  EXPECT_TRUE(report.closed());
  EXPECT_EQ(report.non_manifold_vertices, 0u);
  EXPECT_EQ(report.degenerate_triangles, 0u);
  EXPECT_EQ(report.duplicate_triangles, 0u);
  EXPECT_EQ(report.unused_vertices, 0u);
}

TEST(Tubes, VolumeIsCrossSectionTimesLengthRoundBendsToo) {
  TurtleLine line;
  line.points = {{0, 0, 0}, {0, 0, 2}, {3, 0, 2}, {3, 4, 3}, {2, 8, 9}};
  line.widths.assign(line.points.size(), 0.4);
  double length = 0.0;
  for (std::size_t k = 1; k < line.points.size(); ++k)
    length += glm::distance(line.points[k], line.points[k - 1]);
  for (const int sides : {3, 4, 8, 33}) {
    const Mesh mesh = make_tubes(std::span(&line, 1), {.sides = sides});
    expect_sound(mesh);
    EXPECT_NEAR(enclosed_volume(mesh), std::numbers::pi * 0.04 * length, 1e-6) << sides;
  }
}

TEST(Tubes, OfAllPresetsAreSound) {
  for (const LSystemPreset& preset : lsystem_presets()) {
    SCOPED_TRACE(preset.name);
    const LSystem system = named_lsystem(preset.name);
    const Word word = rewrite(system.grammar, std::min(system.iterations, 6), 1);
    const auto lines = draw_word(word, system.turtle);
    const Mesh mesh = make_tubes(lines, {.sides = 6});
    expect_sound(mesh);
    EXPECT_GT(enclosed_volume(mesh), 0.0);
  }
}

TEST(Tubes, ThatCoincideStayApart) {
  TurtleLine line;
  line.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};  // closed, and drawn three times
  line.widths.assign(line.points.size(), 0.1);
  const std::vector<TurtleLine> lines(3, line);
  const Mesh mesh = make_tubes(lines);
  expect_sound(mesh);
  EXPECT_EQ(inspect(mesh, make_adjacency(mesh)).components, 3u);
}

TEST(Tubes, SharpTurnsAndRepeatedPoints) {
  TurtleLine line;
  line.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0.01, 0}, {0, 0.01, 0}};
  line.widths.assign(line.points.size(), 0.1);
  const Mesh mesh = make_tubes(std::span(&line, 1));
  expect_sound(mesh);
  EXPECT_NEAR(enclosed_volume(mesh), std::numbers::pi * 0.0025 * 2.0, 1e-4);
  line.points.assign(2, glm::dvec3(1.0));
  line.widths.assign(2, 0.1);
  EXPECT_TRUE(make_tubes(std::span(&line, 1)).triangles.empty());
  EXPECT_THROW(make_tubes(std::span(&line, 1), {.sides = 2}), InputError);
}

}  // namespace
}  // namespace verdigris
