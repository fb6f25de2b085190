#include "job.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_map>

#include "checkpoints.hpp"
#include "picture.hpp"
#include "progress.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/exposure/mesh_values.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/mesh/mend.hpp"

using namespace verdigris;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// Scenes are TOML, and TOML is UTF-8: a run with another name could not be repeated.
void check_utf8(const std::filesystem::path& path) {
  try {
    static_cast<void>(nlohmann::json(path.string()).dump());
  } catch (const nlohmann::json::type_error&) {
    throw InputError("file name", "it is not UTF-8, and run.toml could not hold it", "rename the file");
  }
}

// Makes the directory for the results; takes it away again when nothing came to be in it.
class NewDirectory {
 public:
  explicit NewDirectory(std::filesystem::path path)
      : path_(std::move(path)), made_(!std::filesystem::exists(path_)) {
    make_directory(path_);
  }
  NewDirectory(const NewDirectory&) = delete;
  NewDirectory& operator=(const NewDirectory&) = delete;
  ~NewDirectory() {
    std::error_code not_empty;
    if (made_) std::filesystem::remove(path_, not_empty);
  }

 private:
  std::filesystem::path path_;
  bool made_;
};

struct LoadedMesh {
  Mesh mesh;
  ReadReport read;
  MendReport mended;
};

LoadedMesh load(Scene& scene) {
  LoadedMesh loaded;
  loaded.mesh = read_mesh(scene.mesh, &loaded.read);
  const std::string hash = mesh_hash(loaded.mesh);
  if (!scene.mesh_hash.empty() && scene.mesh_hash != hash)
    throw InputError(
        scene.mesh.string(),
        fmt::format("is not the mesh of this scene: its hash is {}, not {}", hash, scene.mesh_hash),
        "find the model the scene was made with, or remove `hash` from the scene to run it on this one");
  scene.mesh_hash = hash;
  if (scene.mend) loaded.mesh = mend(loaded.mesh, &loaded.mended);
  if (!(mesh_area(loaded.mesh) > 0.0))
    throw InputError(scene.mesh.string(), "its faces have no area", "choose a model with a surface");
  return loaded;
}

// Where seeds land, and how far the farthest given point was from the surface.
struct PlacedSeeds {
  std::vector<Seed> seeds;
  double farthest = 0.0;
};

PlacedSeeds place_seeds(const Surface& surface, const Scene& scene, std::size_t file_vertices,
                        const Field<std::uint8_t>& barrier) {
  PlacedSeeds placed;
  const SeedPlan& plan = scene.seeds;
  if (plan.count > 0) {
    placed.seeds = random_seeds(surface, plan.count, scene.seed, barrier);
  } else {
    std::vector<glm::dvec3> points;
    for (const WeightedPoint& p : plan.points) points.push_back(p.position);
    const Mesh& mesh = surface.mesh();
    for (const std::uint32_t v : plan.vertices) {
      const std::size_t known =
          mesh.vertex_of_file.empty() ? mesh.positions.size() : mesh.vertex_of_file.size();
      if (v >= known)
        throw InputError("seeds", fmt::format("there is no vertex {}", v),
                         fmt::format("the file has {} vertices, counted from 0", file_vertices));
      points.push_back(mesh.positions[mesh.vertex_of_file.empty() ? v : mesh.vertex_of_file[v]]);
    }
    if (points.size() > surface.owned_count())
      throw InputError("seeds", fmt::format("{} seeds for {} cells", points.size(), surface.owned_count()),
                       "give fewer seeds, or use smaller cells");
    for (const LocatedCell& cell : locate(surface, points)) {
      placed.seeds.push_back({cell.slot, 1.0});
      placed.farthest = std::max(placed.farthest, cell.distance);
    }
    for (std::size_t k = 0; k < plan.points.size(); ++k) placed.seeds[k].weight = plan.points[k].weight;
  }
  if (!plan.weights.empty()) {
    if (plan.weights.size() != placed.seeds.size())
      throw InputError("seeds",
                       fmt::format("{} weights for {} seeds", plan.weights.size(), placed.seeds.size()),
                       "give one weight for each seed");
    for (std::size_t k = 0; k < placed.seeds.size(); ++k) placed.seeds[k].weight = plan.weights[k];
  }
  return placed;
}

Field<std::uint8_t> make_barrier(const Surface& surface, const Scene& scene, const ReadReport& read) {
  if (scene.barrier.mask.empty()) return {};
  const Field<float> mask = file_values(surface, read_numbers(scene.barrier.mask), read.file_vertices,
                                        read.file_faces, scene.barrier.mask_on, scene.barrier.mask.string());
  Field<std::uint8_t> barrier(mask.size(), 0);
  for (const Row& row : surface.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
      barrier[slot] = mask[slot] >= static_cast<float>(scene.barrier.threshold);
  return barrier;
}

// Steps until nothing changes, the asked number is reached, or the user stops it.
bool grow(AnySimulation& simulation, const Scene& scene, std::uint64_t cells, Progress& progress,
          CheckpointWriter& checkpoints) {
  progress.stage("growing");
  std::uint64_t changed = 0;
  const auto ended = [&] {
    return simulation.finished() || (scene.steps != 0 && simulation.steps() >= scene.steps);
  };
  while (!ended()) {
    changed += simulation.step().changed;
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

// Regions that end at a barrier touch all the same: for the picture no edge bars the view to the other side.
void draw(const std::filesystem::path& file, const Surface& surface, const Field<std::int32_t>& values,
          bool labels, const Scene& scene) {
  if (scene.barrier.angle >= 180.0 || scene.links == LinkKind::projected)
    return write_picture(file, surface, values, labels, scene.picture);
  const Surface open = make_surface(surface.mesh(), {scene.cell_size, scene.links});
  Field<std::int32_t> seen = values;
  open.links().for_each([&](std::uint32_t source, auto ghosts) {
    for (const std::uint32_t ghost : ghosts) seen[ghost] = values[source];
  });
  write_picture(file, open, seen, labels, scene.picture);
}

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
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
  std::optional<tbb::global_control> threads;
  if (options.threads > 0)
    threads.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  Progress progress(!options.quiet);
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& behaviour = catalogue.find(scene.behaviour);
  check_parameters(behaviour.name, behaviour.parameters, scene.parameters);
  if (scene.picture.draw) check_picture(scene.picture);
  check_utf8(scene.mesh);
  check_utf8(scene.barrier.mask);
  const std::filesystem::path out = options.out, checkpoint_file = out / "checkpoint.vgc";
  const CheckpointInterval interval = parse_interval(options.checkpoint_every);
  std::optional<Checkpoint> checkpoint;
  if (options.resume) checkpoint = checkpoint_to_resume(checkpoint_file, scene.steps);
  const NewDirectory place(out);
  if (!options.resume && !options.quiet && std::filesystem::exists(checkpoint_file))
    say("note: {} of an unfinished run is there; --resume would go on from it, this run replaces it\n",
        checkpoint_file.string());
  for (const char* name :
       {"cells.vtp", "regions.csv", "curve.csv", "run.toml", "picture.png", "checkpoint.vgc"})
    remove_abandoned(out / name);
  watch_for_interrupt();

  nlohmann::ordered_json seconds;
  auto begin = Clock::now();
  const auto lap = [&](const char* stage) {
    seconds[stage] = seconds_since(begin);
    begin = Clock::now();
  };
  const auto started = begin;

  progress.stage("reading");
  LoadedMesh loaded = load(scene);
  lap("read");

  progress.stage("building surface");
  if (scene.cell_size <= 0.0) scene.cell_size = cell_size_for(loaded.mesh, scene.cells);
  const Surface surface =
      make_surface(std::move(loaded.mesh), {scene.cell_size, scene.links, scene.barrier.angle});
  if (surface.owned_count() == 0)
    throw InputError(
        scene.mesh.string(),
        fmt::format("cells of {:g} are too large for its triangles: none has the centre of a cell in it",
                    scene.cell_size),
        "use smaller cells (--cell-size), or more of them (--cells)");
  const double coverage = static_cast<double>(surface.owned_count()) * scene.cell_size * scene.cell_size /
                          mesh_area(surface.mesh());
  if (std::abs(coverage - 1.0) > 0.02 && !options.quiet)
    say("warning: the cells cover {:.1f} % of the area: with {:.1f} cells a triangle their number is off, "
        "and areas "
        "with it; use smaller cells (--cells {:.0f})\n",
        100.0 * coverage,
        static_cast<double>(surface.owned_count()) / static_cast<double>(surface.patch_count()),
        std::max(2.0 * static_cast<double>(surface.owned_count()),
                 14.0 * static_cast<double>(surface.patch_count())));
  lap("build");

  Field<std::uint8_t> barrier = make_barrier(surface, scene, loaded.read);
  if (behaviour.needs_seeds && scene.seeds.count == 0 && scene.seeds.points.empty() &&
      scene.seeds.vertices.empty())
    throw InputError("seeds", fmt::format("{} needs some", behaviour.name),
                     "give --seeds, or [seeds] in the scene");
  const PlacedSeeds placed = place_seeds(surface, scene, loaded.read.file_vertices, barrier);
  lap("place_seeds");

  const SimulationSetup setup{surface, scene.seed, placed.seeds, std::move(barrier)};
  const RunIdentity identity = identity_of_run(scene, behaviour, setup);
  const auto simulation = behaviour.create(setup, scene.parameters);
  if (checkpoint) {
    resume(*simulation, *checkpoint, identity, checkpoint_file);
    checkpoint.reset();
  }
  const std::uint64_t first_step = simulation->steps();
  if (options.resume && !options.quiet && !options.json) say("resuming at step {}\n", first_step);
  lap("start");
  CheckpointWriter checkpoints(checkpoint_file, interval, identity);
  const bool complete = grow(*simulation, scene, surface.owned_count(), progress, checkpoints);
  bool resumable = false;
  if (!complete) {
    scene.steps = simulation->steps();
    resumable = checkpoints.write_now(*simulation);  // first: a second Ctrl-C ends the program at once
  }
  lap("grow");
  seconds["checkpoints"] = checkpoints.seconds();  // part of "grow"

  progress.stage("writing cells");
  std::vector<Field<std::int32_t>> fields;
  std::vector<CellArray> arrays;
  for (const FieldInfo& info : simulation->fields()) fields.push_back(simulation->field(info.name));
  for (std::size_t k = 0; k < fields.size(); ++k)
    arrays.push_back({simulation->fields()[k].name, &fields[k]});
  write_cells_vtp(out / "cells.vtp", surface, arrays);
  std::vector<std::string> files{"cells.vtp"};

  std::vector<Region> regions;
  std::uint64_t unreached = 0;
  if (behaviour.name == "voronoi") {
    regions = measure_regions(surface, fields[0], placed.seeds.size());
    std::vector<glm::dvec3> positions;
    for (const Seed& seed : placed.seeds) positions.push_back(surface.position(seed.slot));
    write_regions_csv(out / "regions.csv", regions, positions);
    const auto curve = arrival_curve(surface, fields[1]);
    write_curve_csv(out / "curve.csv", curve, surface.owned_count());
    files.insert(files.end(), {"regions.csv", "curve.csv"});
    unreached = surface.owned_count();
    for (const Region& region : regions) unreached -= region.cells;
  }
  // The size that was used, so that the run can be repeated whatever `cells` comes to mean.
  write_scene(out / "run.toml", scene);
  files.push_back("run.toml");
  lap("write");

  if (scene.picture.draw) {
    progress.stage("drawing");
    draw(out / "picture.png", surface, fields[0], behaviour.name == "voronoi", scene);
    files.push_back("picture.png");
  } else {
    // One of an earlier run would not show these cells.
    std::error_code ignored;
    std::filesystem::remove(out / "picture.png", ignored);
  }
  lap("picture");
  progress.finish();
  if (complete) checkpoints.remove();
  if (resumable) files.push_back(checkpoint_file.filename().string());
  seconds["total"] = seconds_since(started);

  const double grown = seconds["grow"].get<double>() + seconds["start"].get<double>();
  const double cells = static_cast<double>(surface.owned_count());
  if (placed.farthest >
      0.01 * glm::length(mesh_bounds(surface.mesh()).upper - mesh_bounds(surface.mesh()).lower))
    say("warning: a seed point lies {:.4g} model units from the surface; it was moved there\n",
        placed.farthest);
  if (!complete)
    say("stopped after step {}; the results so far are written{}\n", simulation->steps(),
        resumable ? "; the same command with --resume goes on from there" : "");
  if (options.json) {
    nlohmann::ordered_json report{
        {"version", VERDIGRIS_VERSION},
        {"mesh", scene.mesh.string()},
        {"mesh_hash", scene.mesh_hash},
        {"behaviour", scene.behaviour},
        {"complete", complete},
        {"triangles", surface.patch_count()},
        {"cells", surface.owned_count()},
        {"cell_size", surface.cell_size()},
        {"coverage", coverage},
        {"links", name_of(scene.links)},
        {"ghosts", surface.ghost_count()},
        {"ghosts_at_boundaries", surface.open_ghost_count()},
        {"ghosts_lost", surface.lost_ghost_count()},
        {"seeds", placed.seeds.size()},
        {"steps", simulation->steps()},
        {"first_step", first_step},
        {"cells_not_reached", unreached},
        {"bytes_per_cell", static_cast<double>(surface.bytes() + simulation->bytes()) / cells},
        {"peak_memory_bytes", peak_memory_bytes()},
        {"seconds", seconds},
        {"build_cells_per_second", cells / seconds["build"].get<double>()},
        {"grow_cells_per_second", cells / grown},
        {"out", out.string()},
        {"files", files}};
    if (scene.mend)
      report["mended"] = {{"duplicates_removed", loaded.mended.duplicates_removed},
                          {"triangles_flipped", loaded.mended.triangles_flipped},
                          {"unorientable_components", loaded.mended.unorientable_components}};
    fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else if (!options.quiet) {
    fmt::print("{}: {} triangles, {} cells of {:.4g}\n", scene.mesh.filename().string(),
               surface.patch_count(), surface.owned_count(), surface.cell_size());
    if (scene.mend)
      fmt::print(
          "mended: {} duplicate faces removed, {} triangles flipped, {} components that cannot be oriented\n",
          loaded.mended.duplicates_removed, loaded.mended.triangles_flipped,
          loaded.mended.unorientable_components);
    fmt::print("{} seeds, {} steps{}\n", placed.seeds.size(), simulation->steps(),
               unreached == 0 ? "" : fmt::format("; {} cells were not reached", unreached));
    fmt::print(
        "read {:.2f} s, build {:.2f} s ({:.1f} M cells/s), grow {:.2f} s ({:.1f} M cells/s), write {:.2f} s, "
        "picture {:.2f} s; peak memory {:.0f} MB\n",
        seconds["read"].get<double>(), seconds["build"].get<double>(),
        cells / seconds["build"].get<double>() / 1e6, grown, cells / grown / 1e6,
        seconds["write"].get<double>(), seconds["picture"].get<double>(), peak_memory_bytes() / 1e6);
    fmt::print("in {}: {}\n", out.string(), fmt::join(files, ", "));
  }
  return complete ? 0 : 130;
}
