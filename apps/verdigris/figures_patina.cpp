// Figures 22 and 23: patina on the cup, and its growth beside that of regions.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cup.hpp"
#include "figure_models.hpp"
#include "figures.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/io/read_material.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/picture/patina.hpp"
#include "verdigris/picture/plot.hpp"

using namespace verdigris;

namespace {

constexpr std::uint64_t steps = 950;
constexpr double years = 30.0;

Image patina_at(FigureModel& model, const Material& material, const LayerStack& looks,
                const Field<std::int32_t>& arrivals, double step) {
  const double step_years = years / static_cast<double>(steps);
  const auto cells = patina_cells(material, {arrivals, {}, ExposureClass::C3, step_years, step * step_years});
  return model.renderer.draw(LayerPicture{cells, looks}, model.camera);
}

}  // namespace

Image patina_of(FigureModel& model, double share) {
  CorrosionGrowth growth({model.surface, 1}, {});
  for (std::uint64_t step = 0; step < steps; ++step) growth.step();
  const Material copper = find_material("copper");
  return patina_at(model, copper, looks_of(copper), growth.field("arrival"),
                   share * static_cast<double>(steps));
}

void figures_of_patina(FigurePage& page) {
  const double start = processor_seconds();
  FigureModel model(meshes::make_cup(), 220e3, "0.55,0.5,1", 640, 560);
  const std::size_t cells = model.surface.owned_count();
  CorrosionGrowth growth({model.surface, 1}, {});
  for (std::uint64_t step = 0; step < steps; ++step) growth.step();
  const double grown = processor_seconds() - start;
  const Material copper = find_material("copper");
  const LayerStack looks = looks_of(copper);
  const Field<std::int32_t> arrivals = growth.field("arrival");
  std::vector<Panel> panels;
  for (const double step : {80.0, 160.0, 260.0, 400.0, 600.0, 950.0})
    panels.push_back({fmt::format("({}) step {:.0f}: {:.1f} years", "abcdef"[panels.size()], step,
                                  step * years / static_cast<double>(steps)),
                      patina_at(model, copper, looks, arrivals, step)});
  const double all = processor_seconds() - start;
  page.section(
      "Figure 22: patina on a copper cup",
      "Corrosion starts in a few weak places and spreads by attack and defence; brown cuprite comes first, "
      "green brochantite after years. Steps are given years here: sheet copper in air of class C3.");
  page.figure("figure-22", panels, 3);

  const std::vector<std::uint64_t>& births = growth.births();
  VoronoiGrowth regions(
      {model.surface, 1, random_seeds(model.surface, std::max<std::uint64_t>(growth.seeds_placed(), 1), 1)},
      {});
  while (!regions.finished()) regions.step();
  const std::vector<std::uint64_t> filled = arrival_curve(model.surface, regions.arrivals());
  Plot plot{"", "step", "share of the surface (%)", {}, {}};
  plot.curves.push_back({"corrosion", percent_reached(births, cells)});
  std::vector<glm::dvec2> region_points = percent_reached(filled, cells);
  plot.curves.push_back({"regions from as many seeds", region_points});
  plot.y_low = 0.0;
  plot.y_high = 100.0;
  const std::size_t slow = step_of_share(births, cells, 0.99), fast = step_of_share(filled, cells, 0.99);
  plot.marks = {{static_cast<double>(fast), fmt::format("99 % at step {}", fast)},
                {static_cast<double>(slow), fmt::format("99 % at step {}", slow)}};
  page.section(
      "Figure 23: corrosion and regions on the same cup",
      "Corrosion starts slowly, for seeds are few and young cells attack weakly, and ends slowly, where "
      "strong cells hold together. Its curve is logistic without central symmetry.");
  page.figure("figure-23", {{"", draw_plot(plot, 1100, 640)}}, 1);
  const double half = static_cast<double>(step_of_share(births, cells, 0.5));
  page.table({{"input triangles", "approximately 450", fmt::format("{}", model.surface.patch_count()), ""},
              {"cells", "approximately 220 000", fmt::format("{}", cells), ""},
              {"steps up to the last picture", "950", fmt::format("{}", steps), ""},
              {"saturation after that of regions", "about nine times",
               fmt::format("{:.1f} times",
                           static_cast<double>(slow) / static_cast<double>(std::max<std::size_t>(fast, 1))),
               fmt::format("99 % of the surface; {} seeds in both", growth.seeds_placed())},
              {"corroded at half the time to 99 %", "",
               fmt::format("{:.0f} %", percent_reached(births, cells)[slow / 2].y),
               fmt::format("half is reached at step {:.0f}: a symmetric curve would have 50 %", half)},
              {"time, computation alone", "", fmt::format("{:.2f} s", grown), ""},
              {"time, computation and six pictures", "under 20 min", fmt::format("{:.2f} s", all),
               fmt::format("{:.0f} times as fast, if the paper's 20 min are taken", 1200.0 / all)}});
}
