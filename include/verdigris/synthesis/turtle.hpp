#pragma once
// The turtle that draws a word: a position, a heading, a width, and a stack of them for branches.
// Source: Prusinkiewicz 1986, "Graphical applications of L-systems"; ABOP 1.3, 1.5 and 1.6.

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "verdigris/synthesis/grammar.hpp"

namespace verdigris {

/// How symbols are taken.
///
///   F G   draw forward           + -   turn left, right       !   width times `taper`
///   f     move forward           & ^   pitch down, up         |   turn round
///                                \ /   roll left, right       [ ] keep the state, return to it
///
/// Values replace the settings: F(2) draws two steps, +(30) turns 30 degrees, !(0.5) makes half the width of
/// the start. All other symbols do nothing.
struct TurtleSettings {
  double angle = 90.0;      ///< degrees
  double step = 1.0;        ///< length of F, model units; > 0
  double width = 0.1;       ///< full width of a line at the start, model units; > 0
  double taper = 0.7071;    ///< factor of !
  std::string draw = "FG";  ///< symbols that draw forward
  std::string move = "f";   ///< symbols that move forward without a line
  std::string back = {};    ///< symbols that draw backward
};

/// Where a turtle stands and how it looks: heading x left = up, all of length 1.
struct TurtlePose {
  glm::dvec3 position{0.0}, heading{0.0, 1.0, 0.0}, left{-1.0, 0.0, 0.0}, up{0.0, 0.0, 1.0};

  void turn(double degrees);   ///< to the left, about `up`
  void pitch(double degrees);  ///< downwards, about `left`
  void roll(double degrees);   ///< left side down, about `heading`
};

/// A line drawn without lifting the pen. A branch is a line of its own that begins on its parent's; the
/// parent's goes on after it.
struct TurtleLine {
  std::vector<glm::dvec3> points;  ///< two or more
  std::vector<double> widths;      ///< [point]
  int generation = 0;              ///< how many brackets it is in
};

/// Draws a word. In the plane (no pitch, no roll) the lines lie in z = 0. Every bracket that is open at the
/// end is closed; a `]` without a `[` is skipped (parsed grammars have neither). Throws InputError where a
/// length, angle, width or coordinate is not finite or beyond 1e12.
std::vector<TurtleLine> draw_word(const Word& word, const TurtleSettings& settings,
                                  const TurtlePose& start = {});

/// The box around all points; empty lines give a box at the origin.
struct LineBounds {
  glm::dvec3 lower{0.0}, upper{0.0};
};
LineBounds line_bounds(std::span<const TurtleLine> lines);

}  // namespace verdigris
