#include "verdigris/exposure/surface_turtle.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/surface/walk.hpp"
#include "verdigris/synthesis/turtle_commands.hpp"

namespace verdigris {

namespace {

glm::dvec3 turned(const Motion& motion, const glm::dvec3& v) {
  const glm::dvec2 flat = motion.turn({v.x, v.y});
  return {flat.x, flat.y, v.z};
}

struct SurfaceState {
  SurfacePoint at;
  TurtlePose pose;
  double width;
  int generation;
  std::size_t line;
  bool stopped;  // at a boundary: nothing is drawn until the branch ends
};

// Its pose is in the axes of its triangle's frame: z is the normal.
class SurfaceTurtle : public TurtleBase<SurfaceState> {
 public:
  SurfaceTurtle(const Surface& surface, const SurfacePoint& at, const TurtlePose& pose, double width)
      : TurtleBase({at, pose, width, 0, no_line, false}),
        surface_(surface),
        unfolding_(surface.frames(), surface.adjacency()) {}

  void forward(double distance, bool pen_down) {
    if (!pen_down) at_.line = no_line;
    if (at_.stopped) return;
    const glm::dvec2 step = distance * glm::dvec2(at_.pose.heading);
    const Trace trace = unfolding_.trace(at_.at.triangle, at_.at.point, at_.at.point + step, most_crossings);
    pieces_ += trace.pieces.size();
    if (pieces_ > most_pieces || trace.pieces.size() > std::size_t{most_crossings})
      throw InputError("step", "the lines cross edges too often",
                       "draw with a smaller step, or rewrite fewer times");
    if (pen_down) {
      if (at_.line == no_line) begin_line();
      for (const Trace::Piece& piece : trace.pieces) add({piece.patch, piece.to});
      SurfaceLine& line = drawing.lines[at_.line];
      line.stops.push_back(static_cast<std::uint32_t>(line.points.size() - 1));
    }
    at_.at = {trace.pieces.back().patch, trace.pieces.back().to};
    at_.pose.heading = turned(trace.motion, at_.pose.heading);
    at_.pose.left = turned(trace.motion, at_.pose.left);
    at_.pose.up = turned(trace.motion, at_.pose.up);
    if (!trace.whole) {
      at_.stopped = true;
      ++drawing.stopped;
    }
  }

  SurfaceDrawing drawing;

 private:
  void begin_line() {
    at_.line = drawing.lines.size();
    drawing.lines.emplace_back();
    drawing.lines.back().generation = at_.generation;
    add(at_.at);
    drawing.lines.back().stops.push_back(0);
  }
  void add(const SurfacePoint& p) {
    SurfaceLine& line = drawing.lines[at_.line];
    line.points.push_back(p);
    line.positions.push_back(surface_.frame(p.triangle).to_model(p.point));
    line.widths.push_back(at_.width);
  }

  static constexpr int most_crossings = 1 << 20;  // of one step
  static constexpr std::size_t most_pieces = 20'000'000;
  const Surface& surface_;
  Unfolding unfolding_;
  std::size_t pieces_ = 0;
};

// Heading in the plane, up the normal.
TurtlePose pose_on(const Frame& frame, const glm::dvec3& heading) {
  glm::dvec2 flat(glm::dot(heading, frame.u), glm::dot(heading, frame.v));
  const double length = glm::length(flat);
  flat = length > 1e-9 * glm::length(heading) ? flat / length : glm::dvec2(1.0, 0.0);
  TurtlePose pose;
  pose.heading = {flat, 0.0};
  pose.left = {-flat.y, flat.x, 0.0};
  pose.up = {0.0, 0.0, 1.0};
  return pose;
}

}  // namespace

SurfaceDrawing draw_on_surface(const Surface& surface, const Word& word, const TurtleSettings& settings,
                               const SurfaceStart& start) {
  if (surface.patch_count() == 0)
    throw InputError("turtle", "the model has no triangles", "choose a model with a surface");
  if (!std::isfinite(start.heading.x + start.heading.y + start.heading.z))
    throw InputError("heading", "its coordinates are not finite", "give a direction x,y,z");
  const SurfacePoint at = nearest_point(surface, start.at);
  SurfaceTurtle turtle(surface, at, pose_on(surface.frame(at.triangle), start.heading), settings.width);
  command_turtle(word, settings, turtle);
  return std::move(turtle.drawing);
}

}  // namespace verdigris
