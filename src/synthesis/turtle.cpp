#include "verdigris/synthesis/turtle.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "verdigris/base/error.hpp"
#include "verdigris/synthesis/turtle_commands.hpp"

namespace verdigris {

namespace {

// Quarter turns are exact, so that curves on a grid stay on it.
void turn_towards(glm::dvec3& a, glm::dvec3& b, double degrees) {
  const double turns = std::remainder(degrees, 360.0), quarter = turns / 90.0;
  double c = std::cos(turns * std::numbers::pi / 180.0), s = std::sin(turns * std::numbers::pi / 180.0);
  if (quarter == std::floor(quarter)) {
    c = std::round(c);
    s = std::round(s);
  }
  const glm::dvec3 turned = c * a + s * b;
  b = c * b - s * a;
  a = turned;
}

struct SpaceState {
  TurtlePose pose;
  double width;
  int generation;
  std::size_t line;
};

class SpaceTurtle : public TurtleBase<SpaceState> {
 public:
  SpaceTurtle(const TurtlePose& start, double width) : TurtleBase({start, width, 0, no_line}) {}

  void forward(double distance, bool pen_down) {
    const glm::dvec3 from = at_.pose.position;
    at_.pose.position += distance * at_.pose.heading;
    for (int k = 0; k < 3; ++k) check_measure("a coordinate", at_.pose.position[k]);
    if (!pen_down) {
      at_.line = no_line;
      return;
    }
    if (at_.line == no_line) {
      at_.line = lines.size();
      lines.push_back({{from}, {at_.width}, at_.generation});
    }
    lines[at_.line].points.push_back(at_.pose.position);
    lines[at_.line].widths.push_back(at_.width);
  }

  std::vector<TurtleLine> lines;
};

}  // namespace

void refuse_measure(const char* what, double value) {
  throw InputError("turtle", fmt::format("{} of the drawing is {}", what, value),
                   "use smaller numbers in the grammar, a smaller step or fewer iterations");
}

void TurtlePose::turn(double degrees) {
  turn_towards(heading, left, degrees);
}

void TurtlePose::pitch(double degrees) {
  turn_towards(up, heading, degrees);
}

void TurtlePose::roll(double degrees) {
  turn_towards(up, left, degrees);
}

std::vector<TurtleLine> draw_word(const Word& word, const TurtleSettings& settings, const TurtlePose& start) {
  SpaceTurtle turtle(start, settings.width);
  command_turtle(word, settings, turtle);
  return std::move(turtle.lines);
}

LineBounds line_bounds(std::span<const TurtleLine> lines) {
  LineBounds bounds;
  bool any = false;
  for (const TurtleLine& line : lines)
    for (const glm::dvec3& p : line.points) {
      bounds.lower = any ? glm::min(bounds.lower, p) : p;
      bounds.upper = any ? glm::max(bounds.upper, p) : p;
      any = true;
    }
  return bounds;
}

}  // namespace verdigris
