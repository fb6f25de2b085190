#include "report.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "model.hpp"

using namespace verdigris;

namespace {

double peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

double seconds_of(const RunReport& r, const char* stage) {
  return r.seconds.at(stage).get<double>();
}

double grown(const RunReport& r) {
  return seconds_of(r, "grow") + seconds_of(r, "start");
}

}  // namespace

void print_json(const RunReport& r) {
  const double cells = static_cast<double>(r.surface.owned_count());
  nlohmann::ordered_json report{
      {"version", VERDIGRIS_VERSION},
      {"mesh", r.scene.torus.width != 0 ? model_name(r.scene) : r.scene.mesh.string()},
      {"mesh_hash", r.scene.mesh_hash},
      {"behaviour", r.scene.behaviour},
      {"complete", r.complete},
      {"triangles", r.surface.patch_count()},
      {"cells", r.surface.owned_count()},
      {"cell_size", r.surface.cell_size()},
      {"coverage", r.coverage},
      {"links", name_of(r.scene.links)},
      {"ghosts", r.surface.ghost_count()},
      {"ghosts_at_boundaries", r.surface.open_ghost_count()},
      {"ghosts_lost", r.surface.lost_ghost_count()},
      {"seeds", r.seeds},
      {"steps", r.simulation.steps()},
      {"first_step", r.first_step},
      {"updates", r.updates},
      {"cells_not_reached", r.results.unreached},
      {"bytes_per_cell", static_cast<double>(r.surface.bytes() + r.simulation.bytes()) / cells},
      {"peak_memory_bytes", peak_memory_bytes()},
      {"seconds", r.seconds},
      {"build_cells_per_second", cells / seconds_of(r, "build")},
      {"grow_cells_per_second", cells / grown(r)},
      {"updates_per_second", static_cast<double>(r.updates) / seconds_of(r, "grow")},
      {"out", r.out},
      {"files", r.results.files}};
  if (r.scene.mend)
    report["mended"] = {{"duplicates_removed", r.mended.duplicates_removed},
                        {"triangles_flipped", r.mended.triangles_flipped},
                        {"unorientable_components", r.mended.unorientable_components}};
  fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_words(const RunReport& r) {
  const double cells = static_cast<double>(r.surface.owned_count());
  fmt::print("{}: {} triangles, {} cells of {:.4g}\n", model_name(r.scene), r.surface.patch_count(),
             r.surface.owned_count(), r.surface.cell_size());
  if (r.scene.mend)
    fmt::print(
        "mended: {} duplicate faces removed, {} triangles flipped, {} components that cannot be oriented\n",
        r.mended.duplicates_removed, r.mended.triangles_flipped, r.mended.unorientable_components);
  fmt::print("{}{} steps{}\n", r.seeds == 0 ? "" : fmt::format("{} seeds, ", r.seeds), r.simulation.steps(),
             r.results.unreached == 0 ? "" : fmt::format("; {} cells were not reached", r.results.unreached));
  const double updates = static_cast<double>(r.updates) / seconds_of(r, "grow");
  const std::string speed = !r.sweeps       ? fmt::format("{:.1f} M cells/s", cells / grown(r) / 1e6)
                            : updates > 1e9 ? fmt::format("{:.2f} G updates/s", updates / 1e9)
                                            : fmt::format("{:.1f} M updates/s", updates / 1e6);
  fmt::print(
      "read {:.2f} s, build {:.2f} s ({:.1f} M cells/s), grow {:.2f} s ({}), write {:.2f} s, picture {:.2f} "
      "s; "
      "peak memory {:.0f} MB\n",
      seconds_of(r, "read"), seconds_of(r, "build"), cells / seconds_of(r, "build") / 1e6, grown(r), speed,
      seconds_of(r, "write"), seconds_of(r, "picture"), peak_memory_bytes() / 1e6);
  fmt::print("in {}: {}\n", r.out, fmt::join(r.results.files, ", "));
}
