#pragma once
// An L-system as a text: how words start, the rules that rewrite them, and the turtle's settings.

#include <span>
#include <string>
#include <string_view>

#include "verdigris/synthesis/grammar.hpp"
#include "verdigris/synthesis/turtle.hpp"

namespace verdigris {

/// Everything that makes a drawing, but for the seed.
struct LSystem {
  Grammar grammar;
  TurtleSettings turtle;
  int iterations = 4;
};

/// Reads an L-system. One line each, `#` begins a comment:
///
///   angle = 25.7             # degrees; also iterations, step, width, taper, draw, move, back
///   let r = 0.7              # a constant for the rules below
///   axiom = A(1)
///   F -> F[+F]F              # a rule without parameters
///   F @ 0.3 -> F[-F]F        # one of several, drawn by weight
///   A(l) if l > 0.1 -> F(l)[+A(l * r)][-A(l * r)]
///
/// Symbols are any printable characters but blanks, brackets ( ), comma, = and #; [ ] must be in pairs within
/// each word. A symbol may have up to 8 values. Throws InputError naming `where`, line and column.
LSystem parse_lsystem(std::string_view text, const std::string& where);

/// An L-system that comes with the library, in the form that parse_lsystem reads.
struct LSystemPreset {
  const char* name;
  const char* summary;  ///< one line
  const char* text;
};
std::span<const LSystemPreset> lsystem_presets();

/// Throws InputError naming the presets there are.
LSystem named_lsystem(std::string_view name);

/// Whether some symbol of the word leaves the plane: & ^ \ or /.
bool leaves_plane(const Word& word);

}  // namespace verdigris
