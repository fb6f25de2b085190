#include "job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "checkpoints.hpp"
#include "corrosion_results.hpp"
#include "prepared_run.hpp"
#include "report.hpp"
#include "result_place.hpp"
#include "thread_option.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/io/replace_file.hpp"

using namespace verdigris;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Steps until nothing changes, the asked number is reached, or the user stops it.
bool grow(AnySimulation& simulation, const Scene& scene, std::uint64_t cells, Progress& progress,
          CheckpointWriter& checkpoints, std::uint64_t& updates) {
  progress.stage("growing");
  std::uint64_t changed = 0;
  const auto ended = [&] {
    // Patina grows on where nothing more can corrode.
    const bool still = simulation.finished() && scene.corrosion.empty();
    return still || (scene.steps != 0 && simulation.steps() >= scene.steps);
  };
  while (!ended()) {
    const StepReport step = simulation.step();
    changed += step.changed;
    updates += step.visited;
    if (!ended()) checkpoints.after_step(simulation);
    const double share = scene.steps != 0
                             ? static_cast<double>(simulation.steps()) / static_cast<double>(scene.steps)
                             : static_cast<double>(changed) / static_cast<double>(cells);
    progress.update(std::min(share, 1.0), fmt::format("step {}", simulation.steps()));
    // After a step, not before: the scene that repeats the run has to name one.
    if (interrupted() && !ended()) return false;
  }
  return true;
}

// What the simulation depends on, and what it is easier to say of it than that cells lie elsewhere.
RunIdentity identity_of_run(const Scene& scene, const BehaviourEntry& behaviour,
                            const SimulationSetup& setup) {
  RunIdentity identity{{"verdigris version", VERDIGRIS_VERSION},
                       {"mend", scene.mend ? "true" : "false"},
                       {"barrier angle", fmt::format("{}", scene.barrier.angle)}};
  for (auto& pair : identity_of(behaviour, setup, scene.parameters)) identity.push_back(std::move(pair));
  return identity;
}

}  // namespace

int run_job(Scene scene, const RunOptions& options) {
  const ThreadLimit threads(options.threads);
  Progress progress(!options.quiet);
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  std::optional<Material> material;
  if (!scene.corrosion.empty()) material = prepare_corrosion(scene);
  check_scene(scene, behaviour);
  check_inputs(scene, options.out);
  complete_scene(scene, behaviour);
  const std::filesystem::path out = options.out, checkpoint_file = out / "checkpoint.vgc";
  const CheckpointInterval interval = parse_interval(options.checkpoint_every);
  std::optional<Checkpoint> checkpoint;
  if (options.resume) checkpoint = checkpoint_to_resume(checkpoint_file, scene.steps);
  const ResultPlace place(out);
  if (!options.resume && !options.quiet && std::filesystem::exists(checkpoint_file))
    say("note: {} of an unfinished run is there; --resume would go on from it, this run replaces it\n",
        checkpoint_file.string());
  watch_for_interrupt();

  nlohmann::ordered_json seconds;
  auto begin = Clock::now();
  const auto lap = [&](const char* stage) {
    seconds[stage] = seconds_since(begin);
    begin = Clock::now();
  };
  const auto started = begin;

  PreparedRun run(scene, behaviour, progress, options.quiet, lap);
  const Surface& surface = run.surface;
  const SimulationSetup& setup = run.setup;
  const PlacedSeeds& placed = run.placed;
  const auto& simulation = run.simulation;
  const RunIdentity identity = identity_of_run(scene, behaviour, setup);
  if (checkpoint) {
    resume(*simulation, *checkpoint, identity, checkpoint_file);
    checkpoint.reset();
  }
  RunReport report{scene, surface, *simulation, run.model.mended, {}, {}, out.string()};
  report.first_step = simulation->steps();
  if (options.resume && !options.quiet && !options.json) say("resuming at step {}\n", report.first_step);
  lap("start");
  CheckpointWriter checkpoints(checkpoint_file, interval, identity);
  report.complete = grow(*simulation, scene, surface.owned_count(), progress, checkpoints, report.updates);
  bool resumable = false;
  if (!report.complete) {
    scene.steps = simulation->steps();
    resumable = checkpoints.write_now(*simulation);  // first: a second Ctrl-C ends the program at once
  }
  lap("grow");
  seconds["checkpoints"] = checkpoints.seconds();  // part of "grow"

  place.clear();
  progress.stage("writing cells");
  const auto* corrosion = material ? dynamic_cast<const CorrosionGrowth*>(simulation.get()) : nullptr;
  report.results =
      write_results(out, surface, *simulation, placed, setup.masks, !options.no_cells && !corrosion);
  std::vector<std::string>& files = report.results.files;
  const auto add_files = [&](const std::vector<std::string>& more) {
    files.insert(files.end(), more.begin(), more.end());
  };
  if (corrosion)
    add_files(write_corrosion(out, *corrosion, *material, scene.corrosion, setup.masks, !options.no_cells));
  // The size that was used, so that the run can be repeated whatever `cells` comes to mean.
  write_scene(out / "run.toml", scene);
  files.push_back("run.toml");
  lap("write");

  if (scene.picture.draw) {
    progress.stage("drawing");
    if (corrosion) {
      add_files(draw_corrosion(out, *corrosion, *material, scene));
    } else {
      draw_results(out, surface, *simulation, scene);
      files.push_back("picture.png");
    }
    for (const Mask& mask : setup.masks) files.push_back(draw_mask(out, surface, mask, scene));
  }
  lap("picture");
  progress.finish();
  if (report.complete) checkpoints.remove();
  if (resumable) files.push_back(checkpoint_file.filename().string());
  seconds["total"] = seconds_since(started);

  if (placed.farthest >
      0.01 * glm::length(mesh_bounds(surface.mesh()).upper - mesh_bounds(surface.mesh()).lower))
    say("warning: a seed point lies {:.4g} model units from the surface; it was moved there\n",
        placed.farthest);
  if (!report.complete)
    say("stopped after step {}; the results so far are written{}\n", simulation->steps(),
        resumable ? "; the same command with --resume goes on from there" : "");
  report.seconds = std::move(seconds);
  report.seeds = placed.seeds.size();
  report.coverage = run.coverage;
  report.sweeps = behaviour.default_steps != 0;
  if (options.json)
    print_json(report);
  else if (!options.quiet)
    print_words(report);
  return report.complete ? 0 : 130;
}
