#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "options.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/mesh/mend.hpp"
#include "verdigris/mesh/report.hpp"
#include "verdigris/surface/surface.hpp"

using namespace verdigris;

namespace {

struct Options {
  Scene scene;
  SurfaceOptionTexts surface;
  std::string mesh;
  bool json = false;
};

// What a model is, and what cells on it would be.
struct Findings {
  ReadReport read;
  MendReport mended;
  bool mend = false;
  MeshReport mesh;
  std::string hash;
  double suggested_cells = 0.0, suggested_size = 0.0;
  double cell_size = 0.0;  ///< the one looked at: asked for, or suggested
  SurfaceEstimate estimate;
  std::size_t narrow = 0;
};

// A million cells, or more where that would leave triangles with fewer than about fourteen: the coarsest that
// still passes growth from triangle to triangle evenly.
double suggest_cells(const MeshReport& report) {
  return std::max(1e6, 14.0 * static_cast<double>(report.triangles));
}

Findings look(Options& options) {
  Findings f;
  Mesh mesh = read_mesh(options.mesh, &f.read);
  f.hash = mesh_hash(mesh);
  f.mend = options.scene.mend;
  if (f.mend) mesh = mend(mesh, &f.mended);
  f.mesh = inspect(mesh, make_adjacency(mesh));
  if (!(f.mesh.area > 0.0))
    throw InputError(options.mesh, "its faces have no area", "choose a model with a surface");
  f.suggested_cells = suggest_cells(f.mesh);
  f.suggested_size = cell_size_for(mesh, f.suggested_cells);
  const bool asked = !options.surface.cells.empty() || !options.surface.cell_size.empty();
  f.cell_size = options.scene.cell_size > 0.0
                    ? options.scene.cell_size
                    : cell_size_for(mesh, asked ? options.scene.cells : f.suggested_cells);
  f.estimate = estimate_surface(mesh, f.cell_size);
  f.narrow = triangles_narrower_than(mesh, f.cell_size);
  return f;
}

void print_json(const Options& options, const Findings& f) {
  const MeshReport& m = f.mesh;
  const auto point = [](const glm::dvec3& p) { return nlohmann::ordered_json::array({p.x, p.y, p.z}); };
  nlohmann::ordered_json report{
      {"mesh", options.mesh},
      {"format", f.read.format},
      {"hash", f.hash},
      {"file_vertices", f.read.file_vertices},
      {"file_faces", f.read.file_faces},
      {"polygons_triangulated", f.read.polygons_triangulated},
      {"vertices_welded", f.read.weld.vertices_welded},
      {"collapsed_faces", f.read.weld.collapsed_faces},
      {"non_finite_coordinates", 0},
      {"vertices", m.vertices},
      {"unused_vertices", m.unused_vertices},
      {"triangles", m.triangles},
      {"edges", m.edges},
      {"components", m.components},
      {"closed", m.closed()},
      {"boundary_edges", m.boundary_edges},
      {"boundary_loops", m.boundary_loops},
      {"non_manifold_edges", m.non_manifold_edges},
      {"non_manifold_vertices", m.non_manifold_vertices},
      {"inconsistent_edges", m.inconsistent_edges},
      {"degenerate_triangles", m.degenerate_triangles},
      {"duplicate_triangles", m.duplicate_triangles},
      {"area", m.area},
      {"lower", point(m.bounds.lower)},
      {"upper", point(m.bounds.upper)},
      {"edge_length", {{"shortest", m.shortest_edge}, {"mean", m.mean_edge}, {"longest", m.longest_edge}}},
      {"smallest_height", m.smallest_height},
      {"suggested", {{"cells", f.suggested_cells}, {"cell_size", f.suggested_size}}},
      {"cell_size", f.cell_size},
      {"cells", f.estimate.cells},
      {"cells_per_triangle", f.estimate.cells / static_cast<double>(m.triangles)},
      {"triangles_narrower_than_a_cell", f.narrow},
      {"surface_bytes", f.estimate.bytes},
      {"voronoi_bytes", f.estimate.run_bytes}};
  if (f.mend)
    report["mended"] = {{"duplicates_removed", f.mended.duplicates_removed},
                        {"triangles_flipped", f.mended.triangles_flipped},
                        {"unorientable_components", f.mended.unorientable_components}};
  fmt::print("{}\n", report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::string memory(double bytes) {
  return bytes < 1e6   ? fmt::format("{:.0f} kB", bytes / 1e3)
         : bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                       : fmt::format("{:.1f} GB", bytes / 1e9);
}

void line(const char* name, const std::string& value) {
  fmt::print("  {:<26}{}\n", name, value);
}

void count(const char* name, std::size_t number, const char* when_any) {
  line(name, number == 0 ? "0" : fmt::format("{}   {}", number, when_any));
}

void print_text(const Options& options, const Findings& f) {
  const MeshReport& m = f.mesh;
  fmt::print("{} ({}, hash {})\n", options.mesh, f.read.format, f.hash);
  line("file",
       fmt::format(
           "{} vertices, {} faces; {} polygons triangulated, {} vertices welded, {} collapsed faces dropped",
           f.read.file_vertices, f.read.file_faces, f.read.polygons_triangulated, f.read.weld.vertices_welded,
           f.read.weld.collapsed_faces));
  if (f.mend)
    line("mended",
         fmt::format("{} duplicate faces removed, {} triangles flipped, {} components cannot be oriented",
                     f.mended.duplicates_removed, f.mended.triangles_flipped,
                     f.mended.unorientable_components));
  line("mesh", fmt::format("{} vertices, {} edges, {} triangles in {} component{}", m.vertices, m.edges,
                           m.triangles, m.components, m.components == 1 ? "" : "s"));
  line("area", fmt::format("{:.6g}", m.area));
  line("bounds",
       fmt::format("({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", m.bounds.lower.x, m.bounds.lower.y,
                   m.bounds.lower.z, m.bounds.upper.x, m.bounds.upper.y, m.bounds.upper.z));
  line("edge length", fmt::format("{:.4g} to {:.4g}, mean {:.4g}; smallest height {:.4g}", m.shortest_edge,
                                  m.longest_edge, m.mean_edge, m.smallest_height));
  fmt::print("\n{}\n",
             m.closed() && m.non_manifold_vertices + m.degenerate_triangles + m.duplicate_triangles == 0
                 ? "sound: closed, manifold, consistently oriented"
                 : "to know before trusting a run");
  line("boundary", m.boundary_edges == 0 ? "none"
                                         : fmt::format("{} edges in {} loops   growth stops there",
                                                       m.boundary_edges, m.boundary_loops));
  count("non-manifold edges", m.non_manifold_edges, "cut: growth does not cross them");
  count("non-manifold vertices", m.non_manifold_vertices, "growth does not pass between their fans");
  count("inconsistent edges", m.inconsistent_edges,
        f.mend ? "cut: cannot be oriented" : "cut; --mend orients what can be");
  count("degenerate triangles", m.degenerate_triangles,
        "no area, no cells; growth passes through unless links are projected");
  count("duplicate triangles", m.duplicate_triangles, "--mend removes them");
  count("unused vertices", m.unused_vertices, "");
  line("non-finite coordinates", "0");
  fmt::print("\ncells\n");
  line("suggested", fmt::format("--cells {:.0f}   (cell size {:.4g})", f.suggested_cells, f.suggested_size));
  line("at cell size", fmt::format("{:.4g}: {:.0f} cells, {:.1f} a triangle", f.cell_size, f.estimate.cells,
                                   f.estimate.cells / static_cast<double>(m.triangles)));
  if (f.estimate.cells < 8.0 * static_cast<double>(m.triangles))
    line("",
         fmt::format(
             "few cells a triangle: their number and areas will be off; 14 or more are safe (--cells {:.0f})",
             14.0 * static_cast<double>(m.triangles)));
  line("narrower than a cell",
       fmt::format("{} triangles ({:.1f} %)", f.narrow,
                   100.0 * static_cast<double>(f.narrow) / static_cast<double>(m.triangles)));
  if (f.narrow > 0 && m.smallest_height > 0.0)
    line("",
         fmt::format(
             "cells below {:.3g} resolve all; with --links projected growth leaps across narrow triangles",
             m.smallest_height));
  line("memory", fmt::format("{} for the surface, {} with Voronoi growth", memory(f.estimate.bytes),
                             memory(f.estimate.run_bytes)));
}

}  // namespace

void add_info(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("info", "What a model is, what is wrong with it, and what cells it would take");
  command->add_option("MODEL", options->mesh, "Model: OBJ, OFF, PLY, STL, OM, GLB or glTF")->required();
  add_surface_options(*command, options->scene, options->surface);
  command->add_flag("--json", options->json, "As one JSON object on standard output");
  command->callback([options] {
    finish_surface_options(options->scene, options->surface);
    const Findings findings = look(*options);
    options->json ? print_json(*options, findings) : print_text(*options, findings);
  });
}
