#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>

#include "idle_options.hpp"
#include "model.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/surface_turtle.hpp"
#include "verdigris/io/read_lsystem.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_lines.hpp"
#include "verdigris/io/write_mesh.hpp"
#include "verdigris/synthesis/tubes.hpp"

using namespace verdigris;

namespace {

struct Options {
  std::string name, out, on, seed_points;
  int iterations = -1, threads = 0;
  double angle = 0.0, step = 0.0, extent = 0.0, width = 0.0, spacing = 0.0;
  std::uint64_t seed = 1;
  bool tubes = false, word = false, json = false, quiet = false;
  TubeOptions tube;
  std::vector<double> at, heading;
  Scene scene;
  SurfaceOptionTexts surface;
};

// What was made of a word, whatever it was drawn on.
struct Report {
  std::size_t symbols = 0, lines = 0, points = 0, stopped = 0, seeds = 0, triangles = 0;
  double length = 0.0, volume = 0.0;
};

glm::dvec3 triple(const std::vector<double>& numbers, const char* option) {
  if (numbers.size() != 3)
    throw InputError(option, fmt::format("{} numbers", numbers.size()), "give three: x,y,z");
  for (const double number : numbers)
    if (!std::isfinite(number))
      throw InputError(option, fmt::format("{} is not a number", number), "give three: x,y,z");
  return {numbers[0], numbers[1], numbers[2]};
}

LSystem load(const Options& options, const CLI::App& command) {
  // A name without a dot or a slash is that of a preset, unless there is such a file.
  const bool is_file =
      options.name.find_first_of("./") != std::string::npos || std::filesystem::is_regular_file(options.name);
  LSystem system = is_file ? read_lsystem(options.name) : named_lsystem(options.name);
  if (command.count("--iterations") > 0) system.iterations = options.iterations;
  if (command.count("--angle") > 0) system.turtle.angle = options.angle;
  return system;
}

// Step and width from what was asked for; `natural` is the extent that the drawing should have by itself.
void scale(LSystem& system, const Word& word, const Options& options, const CLI::App& command,
           double natural) {
  TurtleSettings& turtle = system.turtle;
  const double step = turtle.step;
  if (command.count("--step") > 0) {
    turtle.step = options.step;
  } else if (const double extent = options.extent > 0.0 ? options.extent : natural; extent > 0.0) {
    const LineBounds bounds = line_bounds(draw_word(word, turtle));
    const glm::dvec3 size = bounds.upper - bounds.lower;
    const double longest = std::max({size.x, size.y, size.z});
    if (longest > 0.0) turtle.step *= extent / longest;
  }
  turtle.width = command.count("--width") > 0 ? options.width : turtle.width * (turtle.step / step);
}

std::vector<Polyline> on_model(const LSystem& system, const Word& word, const Options& options,
                               const Surface& surface, Report& report) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  SurfaceStart start{{0.5 * (bounds.lower + bounds.upper)}, {0.0, 1.0, 0.0}};
  if (!options.at.empty()) start.at = triple(options.at, "--at");
  if (!options.heading.empty()) start.heading = triple(options.heading, "--heading");
  const SurfaceDrawing drawing = draw_on_surface(surface, word, system.turtle, start);
  report.stopped = drawing.stopped;
  if (!options.seed_points.empty()) {
    const auto seeds =
        seeds_along(surface, drawing, options.spacing > 0.0 ? options.spacing : system.turtle.step);
    ReplaceFile file(options.seed_points);
    file.write("# x y z weight: " + options.name + " on " + model_name(options.scene) + "\n");
    for (const Seed& seed : seeds) {
      const glm::dvec3 p = surface.position(seed.slot);
      file.write(fmt::format("{} {} {} {}\n", p.x, p.y, p.z, seed.weight));
    }
    file.commit();
    report.seeds = seeds.size();
  }
  std::vector<Polyline> lines;
  for (const SurfaceLine& line : drawing.lines) {
    lines.push_back({line.positions, line.widths, {}, line.generation});
    for (const SurfacePoint& p : line.points)
      lines.back().triangles.push_back(static_cast<std::int32_t>(p.triangle));
  }
  return lines;
}

std::string ending_of(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

// What cannot be is said before anything is drawn or written.
void check(const Options& options, const CLI::App& command) {
  if (options.on.empty())
    refuse_idle(command,
                {"--seed-points", "--at", "--heading", "--cells", "--cell-size", "--links", "--mend"},
                "there is no model to draw on", "name one with --on, or leave it out");
  if (options.seed_points.empty())
    refuse_idle(command, {"--spacing"}, "no points along the lines are asked for",
                "name a file for them with --seed-points, or leave it out");
  const std::string ending = ending_of(options.out);
  if (options.tubes && !options.out.empty() && ending != ".obj" && ending != ".ply")
    throw InputError("--out", fmt::format("tubes are not written as '{}'", options.out),
                     "give a name that ends in .obj or .ply");
  if (!options.tubes && ending != ".ply")
    refuse_idle(command, {"--sides"}, "lines have no sides", "ask for --tubes, or leave it out");
  if (!options.out.empty() && ending != ".svg" && ending != ".obj" && ending != ".vtp" && ending != ".ply")
    throw InputError("--out", fmt::format("'{}' is no format of drawings", ending),
                     "give a name that ends in .svg, .obj, .vtp or .ply");
}

void write(const Options& options, const std::vector<Polyline>& lines, Report& report) {
  const std::string ending = ending_of(options.out);
  if (options.tubes || ending == ".ply") {
    std::vector<TurtleLine> drawn;
    for (const Polyline& line : lines) drawn.push_back({line.points, line.widths, line.generation});
    const Mesh mesh = make_tubes(drawn, options.tube);
    if (mesh.triangles.empty())
      throw InputError(options.name, "it draws no line", "see that some symbol draws: F, or `draw = ...`");
    report.triangles = mesh.triangles.size();
    report.volume = enclosed_volume(mesh);
    write_mesh(options.out, mesh);
  } else if (ending == ".obj") {
    write_lines_obj(options.out, lines);
  } else if (ending == ".vtp") {
    write_lines_vtp(options.out, lines);
  } else {
    write_lines_svg(options.out, lines);
  }
}

void print(const Options& options, const LSystem& system, const Report& r) {
  if (options.json) {
    const nlohmann::ordered_json report{{"lsystem", options.name},
                                        {"iterations", system.iterations},
                                        {"seed", options.seed},
                                        {"symbols", r.symbols},
                                        {"lines", r.lines},
                                        {"points", r.points},
                                        {"length", r.length},
                                        {"step", system.turtle.step},
                                        {"width", system.turtle.width},
                                        {"triangles", r.triangles},
                                        {"volume", r.volume},
                                        {"stopped_at_boundary", r.stopped},
                                        {"seed_points", r.seeds},
                                        {"out", options.out}};
    fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!options.quiet) {
    fmt::print("{}: {} symbols after {} iterations; {} lines, {} points, length {:.6g}\n", options.name,
               r.symbols, system.iterations, r.lines, r.points, r.length);
    if (r.triangles > 0) fmt::print("tubes of {} triangles, volume {:.6g}\n", r.triangles, r.volume);
    if (r.stopped > 0) fmt::print("{} branches end at a boundary\n", r.stopped);
    if (r.seeds > 0) fmt::print("{} seed points in {}\n", r.seeds, options.seed_points);
    fmt::print("written to {}\n", options.out);
  }
}

void run(Options& options, const CLI::App& command) {
  check(options, command);
  const ThreadLimit threads(options.threads);
  LSystem system = load(options, command);
  const Word word = rewrite(system.grammar, system.iterations, options.seed);
  if (options.word) {
    fmt::print("{}\n", word_text(word));
    return;
  }
  if (options.out.empty())
    options.out = options.tubes         ? "lsystem.obj"
                  : !options.on.empty() ? "lsystem.vtp"
                  : leaves_plane(word)  ? "lsystem.obj"
                                        : "lsystem.svg";
  remove_abandoned(options.out);
  Report report;
  report.symbols = word.size();
  std::vector<Polyline> lines;
  if (!options.on.empty()) {
    options.scene.mesh = options.on;
    finish_surface_options(options.scene, options.surface);
    const Surface surface = lay_cells(load_model(options.scene).mesh, options.scene);
    const Bounds bounds = mesh_bounds(surface.mesh());
    scale(system, word, options, command, 0.5 * glm::distance(bounds.lower, bounds.upper));
    lines = on_model(system, word, options, surface, report);
  } else {
    scale(system, word, options, command, 0.0);
    for (TurtleLine& line : draw_word(word, system.turtle))
      lines.push_back({std::move(line.points), std::move(line.widths), {}, line.generation});
  }
  report.lines = lines.size();
  for (const Polyline& line : lines) {
    report.points += line.points.size();
    for (std::size_t k = 1; k < line.points.size(); ++k)
      report.length += glm::distance(line.points[k - 1], line.points[k]);
  }
  write(options, lines, report);
  print(options, system, report);
}

}  // namespace

void add_lsystem(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("lsystem", "Grow an L-system: as lines, as a solid, or over a model");
  command->add_option("NAME", options->name, "An L-system by name, or a file with its grammar")->required();
  command->add_option("--iterations,-n", options->iterations, "How often to rewrite (default: as it says)")
      ->type_name("N")
      ->check(CLI::Range(0, 1000));
  command->add_option("--angle", options->angle, "Angle of + and - (default: as it says)")
      ->type_name("DEG")
      ->check(within(-360.0, 360.0));
  const auto length = within(1e-12, 1e12);
  auto* step = command->add_option("--step", options->step, "Length of F, model units")->check(length);
  command->add_option("--extent", options->extent, "Length of the whole drawing's longest side instead")
      ->type_name("LENGTH")
      ->check(length)
      ->excludes(step);
  step->type_name("LENGTH");
  command
      ->add_option("--width", options->width, "Width of the first lines (default: in proportion to the step)")
      ->type_name("LENGTH")
      ->check(length);
  command->add_option("--seed", options->seed, "Seed of the random numbers, for rules with weights")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{std::numeric_limits<std::int64_t>::max()}))
      ->capture_default_str();
  command
      ->add_option("--out,-o", options->out,
                   "Result: .svg, .obj or .vtp lines, .ply or (with --tubes) .obj a closed mesh")
      ->type_name("FILE");
  command->add_flag("--tubes", options->tubes, "A tube round each line, closed and oriented");
  command->add_option("--sides", options->tube.sides, "Sides of a tube")
      ->type_name("N")
      ->check(CLI::Range(3, 64))
      ->capture_default_str();
  command->add_option("--on", options->on, "Draw on this model: over its edges, heading carried along")
      ->type_name("MODEL");
  command->add_option("--at", options->at, "Where to start on it: x,y,z (default: nearest to its middle)")
      ->delimiter(',')
      ->type_name("X,Y,Z");
  command->add_option("--heading", options->heading, "Which way to start: x,y,z (default: 0,1,0)")
      ->delimiter(',')
      ->type_name("X,Y,Z");
  command
      ->add_option("--seed-points", options->seed_points,
                   "Also write points along the lines: a file for --seeds of other commands")
      ->type_name("FILE");
  command->add_option("--spacing", options->spacing, "Between these points (default: a step)")
      ->type_name("LENGTH")
      ->check(length);
  add_surface_options(*command, options->scene, options->surface);
  add_thread_option(*command, options->threads);
  command->add_flag("--word", options->word, "Only print the word");
  command->add_flag("--json", options->json, "Report as one JSON object on standard output");
  command->add_flag("--quiet,-q", options->quiet, "No report");
  std::string names;
  for (const LSystemPreset& preset : lsystem_presets())
    names += fmt::format("  {:<22}{}\n", preset.name, preset.summary);
  command->footer("By name:\n" + names);
  command->callback([options, command] { run(*options, *command); });
}
