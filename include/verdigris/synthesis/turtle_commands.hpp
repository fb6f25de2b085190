#pragma once
// What the symbols of a word tell a turtle, wherever it walks: in space, or on a surface.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verdigris/synthesis/turtle.hpp"

namespace verdigris {

/// What a symbol does.
enum class TurtleCommand : std::uint8_t { none, draw, move, turn, pitch, roll, width, push, pop };

/// Throws InputError when a measure of a drawing (a length, a width, a coordinate, an angle) is not finite or
/// beyond 1e12: squares and products of such still are numbers.
[[noreturn]] void refuse_measure(const char* what, double value);
inline void check_measure(const char* what, double value) {
  if (!(std::abs(value) <= 1e12)) refuse_measure(what, value);
}

/// What turtles share wherever they walk: turning, widths, branches. `State` has pose, width, generation and
/// line.
template <typename State>
class TurtleBase {
 public:
  void turn(double degrees) { at_.pose.turn(degrees); }
  void pitch(double degrees) { at_.pose.pitch(degrees); }
  void roll(double degrees) { at_.pose.roll(degrees); }
  void scale_width(double factor) {
    at_.width *= factor;
    check_measure("a width", at_.width);
  }
  void set_width(double width) { at_.width = width; }
  void push() {
    stack_.push_back(at_);
    at_.line = no_line;
    ++at_.generation;
  }
  void pop() {
    if (stack_.empty()) return;
    at_ = stack_.back();
    stack_.pop_back();
  }

 protected:
  static constexpr std::size_t no_line = ~std::size_t{0};
  explicit TurtleBase(const State& start) : at_(start) {}

  State at_;

 private:
  std::vector<State> stack_;
};

/// Tells `turtle` what each symbol says, in model units and degrees. A turtle has
///
///   forward(distance, pen_down), turn(degrees), pitch(degrees), roll(degrees),
///   scale_width(factor), set_width(width), push(), pop()
///
/// Throws InputError for lengths, widths and angles that are not finite or beyond 1e12; what a turtle adds up
/// by itself it checks by itself, with check_measure.
template <typename Turtle>
void command_turtle(const Word& word, const TurtleSettings& settings, Turtle& turtle) {
  std::array<TurtleCommand, 256> commands{};
  std::array<double, 256> sign{};
  const auto is = [&](const std::string& symbols, TurtleCommand command, double way = 1.0) {
    for (const char symbol : symbols) {
      commands[static_cast<unsigned char>(symbol)] = command;
      sign[static_cast<unsigned char>(symbol)] = way;
    }
  };
  is("+", TurtleCommand::turn);
  is("-", TurtleCommand::turn, -1.0);
  is("|", TurtleCommand::turn);
  is("&", TurtleCommand::pitch);
  is("^", TurtleCommand::pitch, -1.0);
  is("\\", TurtleCommand::roll);
  is("/", TurtleCommand::roll, -1.0);
  is("!", TurtleCommand::width);
  is("[", TurtleCommand::push);
  is("]", TurtleCommand::pop);
  is(settings.draw, TurtleCommand::draw);
  is(settings.move, TurtleCommand::move);
  is(settings.back, TurtleCommand::draw, -1.0);

  for (std::size_t k = 0; k < word.size(); ++k) {
    const auto symbol = static_cast<unsigned char>(word.symbols[k]);
    const TurtleCommand command = commands[symbol];
    if (command == TurtleCommand::none) continue;
    const auto values = word.arguments(k);
    const double length = sign[symbol] * (values.empty() ? settings.step : values[0] * settings.step);
    const double angle = sign[symbol] * (!values.empty() ? values[0]
                                         : symbol == '|' ? 180.0
                                                         : settings.angle);
    switch (command) {
      case TurtleCommand::draw:
        check_measure("a length", length);
        turtle.forward(length, true);
        break;
      case TurtleCommand::move:
        check_measure("a length", length);
        turtle.forward(length, false);
        break;
      case TurtleCommand::turn:
        check_measure("an angle", angle);
        turtle.turn(angle);
        break;
      case TurtleCommand::pitch:
        check_measure("an angle", angle);
        turtle.pitch(angle);
        break;
      case TurtleCommand::roll:
        check_measure("an angle", angle);
        turtle.roll(angle);
        break;
      case TurtleCommand::push:
        turtle.push();
        break;
      case TurtleCommand::pop:
        turtle.pop();
        break;
      default:
        if (values.empty()) {
          turtle.scale_width(settings.taper);
        } else {
          check_measure("a width", values[0] * settings.width);
          turtle.set_width(values[0] * settings.width);
        }
    }
  }
}

}  // namespace verdigris
