#pragma once
// The turtle on a model: veins, cracks and roots that follow its surface.
// A step is straight in the unfolded plane of the triangles it crosses (as in Abelson & diSessa 1981, "Turtle
// Geometry", ch. 5 and 6), and the heading is carried along.

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/surface/surface.hpp"
#include "verdigris/surface/surface_point.hpp"
#include "verdigris/synthesis/turtle.hpp"

namespace verdigris {

/// Where the turtle starts: at the surface point nearest to `at`, in the direction of `heading` as far as the
/// surface allows; when it allows none, along the longest edge there.
struct SurfaceStart {
  glm::dvec3 at{0.0}, heading{0.0, 1.0, 0.0};
};

/// A line on the surface. Where it crosses an edge it has a point too, so that it lies in the triangles.
struct SurfaceLine {
  std::vector<SurfacePoint> points;   ///< two or more; [k] in the triangle of the piece that ends there
  std::vector<glm::dvec3> positions;  ///< [point], model space
  std::vector<double> widths;         ///< [point], model units
  std::vector<std::uint32_t> stops;   ///< points that end a step of the turtle; the first is the start
  int generation = 0;                 ///< how many brackets it is in
};

struct SurfaceDrawing {
  std::vector<SurfaceLine> lines;
  std::size_t stopped = 0;  ///< steps that met a boundary: the branch ends there
};

/// Draws a word on the surface. Turns are turns about the normal; a turtle that pitches or rolls draws the
/// shadow of what it would draw in space, straight down on the surface: pitched branches look shorter.
/// Throws InputError for a surface without triangles, for a start that is not finite, for lines that cross
/// edges more than 20 million times, and as draw_word does.
SurfaceDrawing draw_on_surface(const Surface& surface, const Word& word, const TurtleSettings& settings,
                               const SurfaceStart& start);

/// A cell under a line.
struct LineCell {
  std::uint32_t slot;
  int generation;  ///< least of the lines that cover it
  double width;    ///< greatest, model units
};

/// The owned cells whose centres lie within half a line's width of it, and those the line passes through, by
/// slot, each once. Throws InputError for lines so wide that they would cover the surface many times over.
std::vector<LineCell> cells_of(const Surface& surface, const SurfaceDrawing& drawing);

/// `value` in the cells, 0 elsewhere: a mask for a behaviour.
Field<float> mask_of(const Surface& surface, std::span<const LineCell> cells, float value = 1.0f);

/// Seeds for a behaviour every `spacing` along the lines, from their starts on, each cell once; the weight is
/// the line's width relative to the widest. Throws InputError where that is more than 5 million points.
std::vector<Seed> seeds_along(const Surface& surface, const SurfaceDrawing& drawing, double spacing);

}  // namespace verdigris
