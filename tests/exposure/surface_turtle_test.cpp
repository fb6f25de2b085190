// The turtle on a surface draws what it draws in the plane, wherever the surface is flat.

#include "verdigris/exposure/surface_turtle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "shapes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/surface/walk.hpp"
#include "verdigris/synthesis/lsystem.hpp"

namespace verdigris {
namespace {

Word word_of(const std::string& symbols) {
  Word word;
  word.symbols = symbols;
  return word;
}

// Every point lies in its triangle, and every piece in one triangle.
void expect_on_surface(const Surface& surface, const SurfaceDrawing& drawing) {
  for (const SurfaceLine& line : drawing.lines) {
    ASSERT_GE(line.points.size(), 2u);
    ASSERT_EQ(line.positions.size(), line.points.size());
    for (std::size_t k = 0; k < line.points.size(); ++k) {
      const Frame& frame = surface.frame(line.points[k].triangle);
      EXPECT_LT(glm::distance(frame.to_model(line.points[k].point), line.positions[k]), 1e-9);
      for (int e = 0; e < 3; ++e) {
        EXPECT_LT(beyond_edge(frame, e, line.points[k].point), 1e-7 * frame.ab);
        if (k > 0) {
          EXPECT_LT(beyond_edge(frame, e, frame.to_plane(line.positions[k - 1])), 1e-7 * frame.ab);
        }
      }
      if (k > 0) {
        EXPECT_LT(std::abs(glm::dot(frame.normal(), line.positions[k - 1] - frame.origin)), 1e-7 * frame.ab);
      }
    }
  }
}

TEST(SurfaceTurtle, OnAFlatSheetItIsThePlaneTurtle) {
  for (const unsigned triangulation : {1u, 2u, 3u}) {
    const Surface surface = make_surface(shapes::random_plane(0.5, 12.0, triangulation), {.cell_size = 0.1});
    for (const char* name :
         {"koch-curve", "plant", "dragon", "gosper", "hilbert", "branching", "ternary-tree"}) {
      SCOPED_TRACE(name);
      LSystem system = named_lsystem(name);
      const Word word = rewrite(system.grammar, std::min(system.iterations, 4), 1);
      // To a size that fits the sheet.
      auto lines = draw_word(word, system.turtle);
      const LineBounds bounds = line_bounds(lines);
      system.turtle.step = 6.0 / glm::length(bounds.upper - bounds.lower);
      TurtlePose pose;
      pose.position = {0.123, 0.321, 0.0};
      lines = draw_word(word, system.turtle, pose);
      const SurfaceDrawing drawing =
          draw_on_surface(surface, word, system.turtle, {.at = pose.position, .heading = {0, 1, 0}});
      expect_on_surface(surface, drawing);
      EXPECT_EQ(drawing.stopped, 0u);
      ASSERT_EQ(drawing.lines.size(), lines.size());
      double worst = 0.0;
      for (std::size_t k = 0; k < lines.size(); ++k) {
        const SurfaceLine& line = drawing.lines[k];
        ASSERT_EQ(line.stops.size(), lines[k].points.size());
        EXPECT_EQ(line.generation, lines[k].generation);
        for (std::size_t j = 0; j < line.stops.size(); ++j) {
          glm::dvec3 shadow = lines[k].points[j];
          shadow.z = 0.0;
          worst = std::max(worst, glm::distance(line.positions[line.stops[j]], shadow));
          EXPECT_EQ(line.widths[line.stops[j]], lines[k].widths[j]);
        }
      }
      EXPECT_LT(worst, 1e-9);
    }
  }
}

TEST(SurfaceTurtle, RoundACubeAndBack) {
  const Surface surface = make_surface(shapes::cube(1.0), {.cell_size = 0.05});
  TurtleSettings settings;
  settings.step = 0.25;
  const SurfaceStart start{{0.3, 0.2, 1.0}, {1, 0, 0}};
  const SurfaceDrawing drawing = draw_on_surface(surface, word_of(std::string(16, 'F')), settings, start);
  ASSERT_EQ(drawing.lines.size(), 1u);
  expect_on_surface(surface, drawing);
  EXPECT_LT(glm::distance(drawing.lines[0].positions.back(), glm::dvec3(0.3, 0.2, 1.0)), 1e-9);
  for (const glm::dvec3& p : drawing.lines[0].positions) EXPECT_NEAR(p.y, 0.2, 1e-9);
  // Round a corner, where three faces meet, three left turns close: the corner holds 90 degrees of
  // curvature.
  settings.step = 0.4;
  const SurfaceDrawing corner =
      draw_on_surface(surface, word_of("F+F+F"), settings, {{0.8, 0.8, 1.0}, {1, 0, 0}});
  EXPECT_LT(glm::distance(corner.lines[0].positions.back(), glm::dvec3(0.8, 0.8, 1.0)), 1e-9);
}

TEST(SurfaceTurtle, GeodesicsOfASphereClose) {
  const Mesh mesh = read_mesh(VERDIGRIS_MESHES "/sphere.obj");
  const Surface surface = make_surface(mesh, {.cell_size = 0.05});
  TurtleSettings settings;
  const int steps = 200;
  settings.step = 2.0 * std::numbers::pi / steps;
  double worst = 0.0;
  for (const glm::dvec3 heading : {glm::dvec3(1, 0, 0), {0.3, 0.1, 1}, {0.5, 0.5, -0.2}, {0, 0, 1}}) {
    const glm::dvec3 from = glm::normalize(glm::dvec3(0.31, 0.87, 0.23));
    const SurfaceDrawing drawing =
        draw_on_surface(surface, word_of(std::string(steps, 'F')), settings, {from, heading});
    expect_on_surface(surface, drawing);
    worst =
        std::max(worst, glm::distance(drawing.lines[0].positions.front(), drawing.lines[0].positions.back()));
  }
  RecordProperty("gap", std::to_string(worst));
  EXPECT_LT(worst, 0.15);
}

TEST(SurfaceTurtle, BranchesEndAtABoundaryAndOthersGoOn) {
  const Surface surface = make_surface(shapes::square(1.0), {.cell_size = 0.05});
  TurtleSettings settings;
  settings.step = 0.4;
  const SurfaceDrawing drawing =
      draw_on_surface(surface, word_of("F[+FFF]F"), settings, {{0.3, 0.1, 0.0}, {0, 1, 0}});
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_EQ(drawing.stopped, 1u);
  EXPECT_NEAR(drawing.lines[1].positions.back().x, 0.0, 1e-12);
  EXPECT_NEAR(drawing.lines[0].positions.back().y, 0.9, 1e-12);
  expect_on_surface(surface, drawing);
}

TEST(SurfaceTurtle, CellsUnderALineAreABandOfItsWidth) {
  const Surface surface = make_surface(shapes::random_plane(0.7, 6.0, 5), {.cell_size = 0.02});
  TurtleSettings settings;
  settings.step = 4.0;
  settings.width = 0.3;
  const SurfaceDrawing drawing = draw_on_surface(surface, word_of("F"), settings, {{-1, -2, 0}, {0.2, 1, 0}});
  const auto cells = cells_of(surface, drawing);
  EXPECT_NEAR(static_cast<double>(cells.size()) * 0.02 * 0.02, 4.0 * 0.3, 0.1 * 1.2);
  const glm::dvec3 from = drawing.lines[0].positions.front(), to = drawing.lines[0].positions.back();
  for (const LineCell& cell : cells) {
    EXPECT_TRUE(surface.is_owned(cell.slot));
    EXPECT_LT(glm::length(glm::cross(surface.position(cell.slot) - from, (to - from) / 4.0)), 0.15 + 0.02);
  }
  EXPECT_TRUE(std::is_sorted(cells.begin(), cells.end(), [](auto& a, auto& b) { return a.slot < b.slot; }));
  const Field<float> mask = mask_of(surface, cells);
  EXPECT_EQ(static_cast<std::size_t>(std::count(mask.begin(), mask.end(), 1.0f)), cells.size());
  const auto seeds = seeds_along(surface, drawing, 0.5);
  EXPECT_EQ(seeds.size(), 9u);
  for (const Seed& seed : seeds) {
    EXPECT_EQ(mask[seed.slot], 1.0f);
    EXPECT_EQ(seed.weight, 1.0);
  }
}

TEST(SurfaceTurtle, FollowsModelsAndIsTheSameTwice) {
  const Surface surface = make_surface(read_mesh(VERDIGRIS_MESHES "/torus.obj"), {.cell_size = 0.02});
  const LSystem roots = named_lsystem("roots");
  TurtleSettings settings = roots.turtle;
  settings.step = 0.07;
  const Word word = rewrite(roots.grammar, roots.iterations, 7);
  const SurfaceDrawing one = draw_on_surface(surface, word, settings, {{2, 1, 0}, {0, 0, 1}});
  expect_on_surface(surface, one);
  EXPECT_EQ(one.stopped, 0u);
  EXPECT_GT(one.lines.size(), 5u);
  const SurfaceDrawing two = draw_on_surface(surface, word, settings, {{2, 1, 0}, {0, 0, 1}});
  ASSERT_EQ(one.lines.size(), two.lines.size());
  for (std::size_t k = 0; k < one.lines.size(); ++k)
    EXPECT_EQ(one.lines[k].positions, two.lines[k].positions);
  EXPECT_THROW(draw_on_surface(surface, word, settings, {{std::nan(""), 0, 0}, {0, 0, 1}}), InputError);
}

TEST(SurfaceTurtle, NeverRunsAway) {
  const Surface surface = make_surface(shapes::cube(1.0), {.cell_size = 0.01});
  TurtleSettings settings;
  settings.step = 1e6;
  EXPECT_THROW(
      draw_on_surface(surface, word_of(std::string(1000, 'F')), settings, {{0.3, 0.2, 1.0}, {1, 0.1, 0}}),
      InputError);
  settings.step = 1.0;
  settings.width = 1e6;
  const SurfaceDrawing wide = draw_on_surface(surface, word_of("F"), settings, {{0.3, 0.2, 1.0}, {1, 0, 0}});
  EXPECT_THROW(cells_of(surface, wide), InputError);
}

TEST(SurfaceTurtle, BoundsSeedsAndTakesNegativeWidthsForNone) {
  const Surface surface = make_surface(shapes::cube(1.0), {.cell_size = 0.01});
  SurfaceDrawing drawing =
      draw_on_surface(surface, word_of("F"), {.step = 0.5, .width = 0.1}, {{0.3, 0.2, 1.0}, {1, 0, 0}});
  for (double& width : drawing.lines[0].widths) width = -1e300;
  EXPECT_LE(cells_of(surface, drawing).size(), 101u);
  for (const Seed& seed : seeds_along(surface, drawing, 0.1)) EXPECT_EQ(seed.weight, 1.0);
  drawing.lines[0].widths.back() = 0.1;
  EXPECT_EQ(seeds_along(surface, drawing, 0.1).front().weight, 0.0);
  const SurfaceDrawing endless =
      draw_on_surface(surface, word_of(std::string(120, 'F')), {.step = 500.0}, {{0.3, 0.2, 1.0}, {1, 0, 0}});
  EXPECT_THROW(seeds_along(surface, endless, 0.01), InputError);
}

}  // namespace
}  // namespace verdigris
