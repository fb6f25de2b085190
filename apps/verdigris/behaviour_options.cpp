#include "behaviour_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "verdigris/base/error.hpp"
#include "verdigris/io/read_points.hpp"

using namespace verdigris;

namespace {

// The greatest whole number a scene can hold.
constexpr std::uint64_t most_whole = std::numeric_limits<std::int64_t>::max();

// A whole number is a count; anything else must be a file.
void finish_seeds(BehaviourOptions& options, bool needed) {
  SeedPlan& plan = options.scene.seeds;
  if (options.seeds.empty() && plan.vertices.empty() && needed) plan.count = 64;
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

void finish_model(BehaviourOptions& options, const BehaviourEntry& entry) {
  Scene& scene = options.scene;
  if (options.mesh.empty() == options.torus.empty())
    throw InputError(entry.name, options.mesh.empty() ? "no model is given" : "a model and a torus are given",
                     "name a model file, or give --torus WxH for a flat periodic grid");
  scene.mesh = options.mesh;
  if (options.torus.empty()) return;
  if (!options.surface.cells.empty() || !options.surface.cell_size.empty())
    throw InputError("--torus", "its size says how many cells there are, of side 1",
                     "leave --cells and --cell-size out");
  int width = 0, height = 0;
  parse_torus(options.torus, width, height);
  scene.torus.width = static_cast<std::uint32_t>(width);
  scene.torus.height = static_cast<std::uint32_t>(height);
  if (options.scene.picture.view == "iso") scene.picture.view = "front";
}

void finish_parameters(BehaviourOptions& options, const BehaviourEntry& entry) {
  for (const ParameterInfo& p : entry.parameters) {
    const std::string& text = options.parameters[p.name];
    options.scene.parameters.emplace_back(
        p.name, text.empty() ? p.default_value : parse_parameter("--" + p.name, p, text));
  }
}

void add_seed_options(CLI::App& command, const std::shared_ptr<BehaviourOptions>& options, bool needed) {
  Scene& scene = options->scene;
  auto* seeds =
      command
          .add_option(
              "--seeds", options->seeds,
              fmt::format("How many seeds at random{}, or a file of `x y z [weight]` lines; line k is "
                          "label k",
                          needed ? " (default 64)" : ""))
          ->type_name("N|FILE");
  command
      .add_option("--seed-vertices", scene.seeds.vertices,
                  "Vertices of the file to start from, counted from 0: 5,17,120")
      ->delimiter(',')
      ->type_name("LIST")
      ->excludes(seeds);
  if (needed)
    command
        .add_option("--seed-weights", scene.seeds.weights,
                    "Speed of each label relative to the others: 1,1,2")
        ->delimiter(',')
        ->type_name("LIST");
}

void add_barrier_options(CLI::App& command, const std::shared_ptr<BehaviourOptions>& options) {
  BarrierPlan& barrier = options->scene.barrier;
  command
      .add_option("--barrier-angle", barrier.angle,
                  "Growth does not cross edges whose faces turn by more degrees")
      ->type_name("DEG")
      ->check(within(0.0, 180.0));
  auto* mask = command.add_option("--barrier-mask", options->mask,
                                  "File of numbers, one a vertex or a face of the model, that bars growth");
  mask->type_name("FILE");
  command
      .add_option("--barrier-mask-on", barrier.mask_on,
                  "What the mask has a number for: vertices or faces (default: told by how many there are)")
      ->needs(mask)
      ->type_name("WHAT");
  command
      .add_option("--barrier-threshold", barrier.threshold, "Cells whose mask is at least this are barred")
      ->needs(mask)
      ->type_name("X")
      ->capture_default_str();
}

void finish_barrier(BehaviourOptions& options) {
  BarrierPlan& barrier = options.scene.barrier;
  barrier.mask = options.mask;
  if (!std::isfinite(barrier.threshold))
    throw InputError("--barrier-threshold", fmt::format("{} is not a number", barrier.threshold),
                     "give a number");
  check_mask_on(barrier.mask_on, "--barrier-mask-on");
}

}  // namespace

void add_behaviour_options(CLI::App& command, const std::shared_ptr<BehaviourOptions>& options,
                           const BehaviourEntry& entry, std::span<const std::string_view> without) {
  Scene& scene = options->scene;
  scene.behaviour = entry.name;
  command.add_option("MODEL", options->mesh, "Model: OBJ, OFF, PLY, STL, OM, GLB or glTF");
  auto* torus = command.add_option("--torus", options->torus,
                                   "A flat periodic grid of so many cells instead: 4096x4096");
  torus->type_name("WxH");
  command
      .add_option("--torus-patch", scene.torus.patch,
                  "Length of its triangles in cells: even, and W and H are multiples of it")
      ->needs(torus)
      ->type_name("N")
      ->capture_default_str();
  add_seed_options(command, options, entry.needs_seeds);
  add_surface_options(command, scene, options->surface);
  for (const ParameterInfo& p : entry.parameters) {
    if (std::find(without.begin(), without.end(), p.name) != without.end()) continue;
    command
        .add_option("--" + p.name, options->parameters[p.name],
                    fmt::format("{} (default {})", p.help, short_text(p.default_value)))
        ->type_name(p.is_text() ? "TEXT" : "X");
  }
  add_barrier_options(command, options);
  command
      .add_option("--steps", scene.steps,
                  fmt::format("Stop after so many steps (default: {})",
                              entry.default_steps != 0 ? std::to_string(entry.default_steps)
                                                       : "when nothing can change"))
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{1}, most_whole));
  command.add_option("--seed", scene.seed, "Seed of the random numbers")
      ->type_name("N")
      ->check(CLI::Range(std::uint64_t{0}, most_whole))
      ->capture_default_str();
  add_picture_options(command, scene, options->picture);
  add_run_options(command, options->run);
}

void finish_behaviour_options(BehaviourOptions& options, const BehaviourEntry& entry) {
  finish_model(options, entry);
  finish_parameters(options, entry);
  finish_barrier(options);
  finish_surface_options(options.scene, options.surface);
  finish_picture_options(options.scene, options.picture);
  finish_seeds(options, entry.needs_seeds);
}
