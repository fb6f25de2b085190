// Figures 2, 10, 16 and 17: growth of regions.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "cup.hpp"
#include "figure_models.hpp"
#include "figures.hpp"
#include "solids.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/picture/plot.hpp"

using namespace verdigris;

namespace {

constexpr double disc_half = 150.0;  // cells, half the shared edge

// Two triangles in one plane whose grids lie at 45 degrees: the common edge, x = 0, is the longest of the
// left one and a leg of the right one.
Mesh disc_mesh() {
  Mesh mesh;
  mesh.positions = {
      {0, -disc_half, 0}, {0, disc_half, 0}, {-1.7 * disc_half, 0, 0}, {2.0 * disc_half, -disc_half, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}};
  return mesh;
}

constexpr glm::dvec3 disc_middle{-4.0, -0.4 * disc_half, 0.0};

// Cells within `radius` of the seed and how many of them were reached.
double completed(const Surface& surface, const Field<std::int32_t>& arrivals, glm::dvec3 middle, int radius) {
  int inside = 0, reached = 0;
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t slot = surface.owned(row).begin; slot < surface.owned(row).end; ++slot)
      if (glm::distance(surface.position(slot), middle) <= radius) {
        ++inside;
        reached += arrivals[slot] >= 0 && arrivals[slot] <= radius;
      }
  return 100.0 * reached / std::max(inside, 1);
}

}  // namespace

void figure_of_discs(FigurePage& page) {
  const Surface surface = make_surface(disc_mesh(), {.cell_size = 1.0});
  const std::uint32_t seed = locate(surface, std::array{disc_middle})[0].slot;
  const glm::dvec3 middle = surface.position(seed);
  constexpr std::array<int, 8> radii{10, 18, 27, 35, 44, 53, 61, 70};
  constexpr int runs = 20;
  std::array<double, 8> share{};
  Field<std::int32_t> arrivals;
  for (int run = runs; run >= 1; --run) {
    VoronoiGrowth growth({surface, static_cast<std::uint64_t>(run), {{seed, 1.0}}}, {});
    for (int step = 0; step < radii.back(); ++step) growth.step();
    arrivals = growth.arrivals();
    for (std::size_t k = 0; k < radii.size(); ++k)
      share[k] += completed(surface, arrivals, middle, radii[k]) / runs;
  }
  RenderOptions flat;
  flat.light.ambient = 1.0f;
  flat.light.diffuse = flat.light.specular = 0.0f;
  flat.samples = 1;
  SurfaceRenderer renderer(surface, flat);
  Camera camera({0, 0, 1}, {0, 1, 0});
  camera.width = camera.height = 480;
  camera.eye = middle + glm::dvec3(0, 0, 2000.0);
  camera.tangent = 82.0 / 2000.0;
  camera.near = 1900.0;
  camera.far = 2100.0;
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    std::vector<Rgba8> colours(surface.slot_count(), {236, 234, 228, 255});
    for (std::size_t slot = 0; slot < colours.size(); ++slot)
      if (arrivals[slot] >= 0 && arrivals[slot] <= radii[k]) colours[slot] = {62, 148, 112, 255};
    Panel panel{fmt::format("({}) radius {} cells, {:.1f} % completed", "abcdefgh"[k], radii[k], share[k]),
                renderer.draw(colours, camera)};
    const auto pixel = [&](glm::dvec3 p) { return glm::dvec2(camera.to_pixel(p)); };
    panel.overlay.line(pixel({0, -disc_half, 0}), pixel({0, disc_half, 0}), "#c81e1e", 1.5);
    panel.overlay.circle(pixel(middle),
                         glm::distance(pixel(middle), pixel(middle + glm::dvec3(radii[k], 0, 0))), "#c81e1e",
                         1.5);
    panels.push_back(std::move(panel));
  }
  page.section(
      "Figure 10: a disc across an edge",
      "Growth from one seed four cells beside an edge, where the two grids lie at 45 degrees to each other: "
      "the worst case. Red: the edge and the ideal circle.");
  page.figure("figure-10", panels, 4);
  const std::string remark = fmt::format(
      "mean of {} runs. The paper does not say how it counts; here it is the share of the "
      "cells within the circle that are filled after as many steps as its radius has cells",
      runs);
  page.table(
      {{"completed at 10 cells", "87 %", fmt::format("{:.1f} %", share[0]), remark},
       {"completed at 70 cells", "99.9 %", fmt::format("{:.1f} %", share[7]),
        share[7] < 99.85 ? "a little less: the front is rough at the scale of a cell, on a flat grid too"
                         : ""}});
}

void figures_of_regions(FigurePage& page) {
  const double start = processor_seconds();
  FigureModel model(meshes::make_vase(), 250e3, "0.35,0.35,1", 560, 560);
  const std::size_t cells = model.surface.owned_count();
  VoronoiGrowth growth({model.surface, 3, random_seeds(model.surface, 28, 3)}, {});
  while (!growth.finished()) growth.step();
  const double grown = processor_seconds() - start;
  const Field<std::int32_t> labels = growth.labels(), arrivals = growth.arrivals();
  const std::vector<std::uint64_t> curve = arrival_curve(model.surface, arrivals);
  const auto steps = static_cast<std::int32_t>(curve.size() - 1);
  std::vector<Panel> panels{model.triangles("(a) input triangles with the normals of their vertices")};
  for (const double share : {0.08, 0.2, 0.4, 0.65, 1.0}) {
    const auto step = static_cast<std::int32_t>(std::lround(share * steps));
    panels.push_back(
        {fmt::format("({}) step {}", "abcdef"[panels.size()], step), model.regions(labels, arrivals, step)});
  }
  const double all = processor_seconds() - start;
  page.section("Figure 17: regions on a simple object",
               "Systematic growth from 28 seeds, over all edges alike.");
  page.figure("figure-17", panels, 3);

  Plot plot{"", "step", "share of the surface (%)", {}, {}};
  plot.curves.push_back({"filled", percent_reached(curve, cells)});
  PlotCurve fresh{"filled in the step, ten times", {}};
  for (std::size_t step = 0; step < curve.size(); ++step)
    fresh.points.emplace_back(step, 1000.0 * static_cast<double>(curve[step]) / static_cast<double>(cells));
  plot.curves.push_back(fresh);
  page.section(
      "Figure 16: how the regions spread",
      "The curve is logistic without central symmetry: growth is easy at first, for every seed has room "
      "around it, and the last corners are filled slowly.");
  page.figure("figure-16", {{"", draw_plot(plot, 1100, 640)}}, 1);
  page.table({{"input triangles", "50", fmt::format("{}", model.surface.patch_count()), "a twisted vase"},
              {"cells", "about 250 000", fmt::format("{}", cells), ""},
              {"steps", "110", fmt::format("{}", steps),
               "it depends on how many seeds there are, which the paper does not say: 28 here"},
              {"half filled at step", "", fmt::format("{}", step_of_share(curve, cells, 0.5)), ""},
              {"time, growth alone", "", fmt::format("{:.3f} s", grown), "cells and links included"},
              {"time, growth and six pictures", "under 10 min", fmt::format("{:.2f} s", all),
               fmt::format("{:.0f} times as fast, if the paper's 10 min are taken", 600.0 / all)}});
}

void figure_of_the_cup(FigurePage& page) {
  FigureModel coarse(meshes::make_cup(), 20e3, "0.55,0.5,1", 640, 560);
  FigureModel fine(meshes::make_cup(), 220e3, "0.55,0.5,1", 640, 560);
  VoronoiGrowth growth({fine.surface, 5, random_seeds(fine.surface, 30, 5)}, {});
  while (!growth.finished()) growth.step();
  std::vector<Panel> panels{
      fine.triangles("(a) input triangles with the normals of their vertices"),
      {"(b) its cells, 20 000", coarse.cells()},
      {"(c) Voronoi regions", fine.regions(growth.labels(), growth.arrivals(), 1 << 30)},
      {"(d) copper patina", patina_of(fine, 0.62)}};
  page.section("Figure 2: one cup at different states", "A cup of our own, with handle and foot.");
  page.figure("figure-02", panels, 2);
  page.table({{"input triangles", "approximately 100", fmt::format("{}", fine.surface.patch_count()),
               "one cup serves here and for figure 22, where the paper's has about 450"},
              {"cells in (b)", "20 000", fmt::format("{}", coarse.surface.owned_count()), ""}});
}
