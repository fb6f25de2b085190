#pragma once
// The Mandelbrot set and Julia sets of z^2 + c, by how soon points escape.
// Sources: Mandelbrot 1980, "Fractal aspects of the iteration of z -> lambda z (1 - z)"; Peitgen & Saupe
// 1988, "The Science of Fractal Images", 4.2.

#include <glm/vec2.hpp>
#include <span>

namespace verdigris {

struct EscapeOptions {
  int most_iterations = 256;  ///< points that stay so long count as inside; >= 1
  double radius = 16.0;       ///< beyond it a point has escaped; at least 2. Wide makes counts smooth
};

/// What the iterated points come to, [point]: how many iterations it takes to escape, with a fraction so that
/// the count is a continuous function of the point; `most_iterations` where it does not escape.
///
/// Mandelbrot: each point is c, z starts at 0. Julia: each point is z, c is given. All spans of one length;
/// the same bits whatever their length.
void mandelbrot_counts(std::span<const double> x, std::span<const double> y, const EscapeOptions& options,
                       std::span<double> counts);
void julia_counts(std::span<const double> x, std::span<const double> y, glm::dvec2 c,
                  const EscapeOptions& options, std::span<double> counts);

/// Whether the critical orbit of c stays: then c is in the Mandelbrot set, and its Julia set is connected.
bool in_mandelbrot_set(glm::dvec2 c, int most_iterations);

}  // namespace verdigris
