#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>

#include "job.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"

using namespace verdigris;

namespace {

struct Options {
  Scene scene;
  RunOptions run;
  SurfaceOptionTexts surface;
  PictureOptionTexts picture;
  std::string mesh, seeds, mask;
  std::map<std::string, double> parameters;
};

// The greatest whole number a scene can hold.
constexpr std::uint64_t most_whole = std::numeric_limits<std::int64_t>::max();

// A whole number is a count; anything else must be a file.
void finish_seeds(Options& options) {
  SeedPlan& plan = options.scene.seeds;
  if (options.seeds.empty() && plan.vertices.empty()) plan.count = 64;
  if (options.seeds.empty()) return;
  const bool is_count = options.seeds.find_first_not_of("0123456789.eE+-kKMG") == std::string::npos;
  if (is_count && !std::filesystem::is_regular_file(options.seeds)) {
    const double count = parse_count(options.seeds, "--seeds");
    if (count != static_cast<double>(static_cast<std::uint64_t>(std::min(count, 1e15))))
      throw InputError("--seeds", fmt::format("'{}' is not a whole number", options.seeds),
                       "give a count or a file of points");
    plan.count = static_cast<std::uint64_t>(count);
  } else {
    plan.points = read_points(options.seeds);
  }
}

}  // namespace

void add_voronoi(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  Scene& scene = options->scene;
  auto* command = app.add_subcommand("voronoi", "Partition a model's surface by growth from seeds");
  command->add_option("MODEL", options->mesh, "Model: OBJ, OFF, PLY, STL, OM, GLB or glTF")->required();

  auto* seeds =
      command
          ->add_option(
              "--seeds", options->seeds,
              "How many seeds at random (default 64), or a file of `x y z [weight]` lines; line k is label k")
          ->type_name("N|FILE");
  command
      ->add_option("--seed-vertices", scene.seeds.vertices,
                   "Vertices of the file to start from, counted from 0: 5,17,120")
      ->delimiter(',')
      ->type_name("LIST")
      ->excludes(seeds);
  command
      ->add_option("--seed-weights", scene.seeds.weights, "Speed of each label relative to the others: 1,1,2")
      ->delimiter(',')
      ->type_name("LIST");
  add_surface_options(*command, scene, options->surface);
  for (const ParameterInfo& p : describe_parameters<VoronoiParameters>())
    command
        ->add_option("--" + p.name, options->parameters[p.name],
                     fmt::format("{} (default {:.4g})", p.help, std::get<double>(p.default_value)))
        ->type_name("X");
  command
      ->add_option("--barrier-angle", scene.barrier.angle,
                   "Growth does not cross edges whose faces turn by more degrees")
      ->type_name("DEG")
      ->check(CLI::Range(0.0, 180.0));
  command
      ->add_option("--barrier-mask", options->mask,
                   "File of numbers, one a vertex or a face of the model, that bars growth")
      ->type_name("FILE");
  command
      ->add_option("--barrier-mask-on", scene.barrier.mask_on,
                   "What the mask has a number for: vertices or faces (default: told by how many there are)")
      ->type_name("WHAT");
  command
      ->add_option("--barrier-threshold", scene.barrier.threshold,
                   "Cells whose mask is at least this are barred")
      ->type_name("X")
      ->capture_default_str();
  command->add_option("--steps", scene.steps, "Stop after so many steps (default: when nothing can change)")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, most_whole));
  command->add_option("--seed", scene.seed, "Seed of the random numbers")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, most_whole))
      ->capture_default_str();
  add_picture_options(*command, scene, options->picture);
  add_run_options(*command, options->run);
  command->footer(
      "Writes cells.vtp, regions.csv, curve.csv, picture.png, and run.toml, which repeats the run to the "
      "bit.");
  command->callback([options, command, &status] {
    Scene& plan = options->scene;
    plan.mesh = options->mesh;
    plan.barrier.mask = options->mask;
    for (const ParameterInfo& p : describe_parameters<VoronoiParameters>())
      plan.parameters.emplace_back(p.name, command->count("--" + p.name) > 0
                                               ? ParameterValue(options->parameters[p.name])
                                               : p.default_value);
    for (const double value : {plan.barrier.angle, plan.barrier.threshold})
      if (!std::isfinite(value))
        throw InputError("--barrier-angle, --barrier-threshold", fmt::format("{} is not a number", value),
                         "give a number");
    check_mask_on(plan.barrier.mask_on, "--barrier-mask-on");
    finish_surface_options(plan, options->surface);
    finish_picture_options(plan, options->picture);
    finish_seeds(*options);
    status = run_job(plan, options->run);
  });
}
