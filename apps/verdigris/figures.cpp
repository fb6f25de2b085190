// verdigris figures: the paper again.

#include "figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "options.hpp"
#include "progress.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/picture/plot.hpp"

using namespace verdigris;

void figure_of_orientation(FigurePage& page) {
  Plot plot{"", "difference of orientation (degrees)", "error (%)", {}, {}};
  PlotCurve curve{"1 - cos x", {}}, mean{"mean, 1 - 2 sqrt(2) / pi", {}};
  for (int k = 0; k <= 450; ++k)
    curve.points.emplace_back(0.1 * k, 100.0 * (1.0 - std::cos(0.1 * k * std::numbers::pi / 180.0)));
  const double error = 100.0 * (1.0 - 2.0 * std::numbers::sqrt2 / std::numbers::pi);
  mean.points = {{0.0, error}, {45.0, error}};
  mean.style = PlotCurve::Style::dashed;
  plot.curves = {curve, mean};
  page.section(
      "Figure 8: two grids, turned against each other",
      "The cells of two triangles lie at any angle from 0 to 45 degrees to each other. The paper pairs the "
      "cells that an edge crosses by projection, and estimates the error as 1 - cos x.");
  page.figure("figure-08", {{"", draw_plot(plot, 1100, 640)}}, 1);
  page.table(
      {{"mean error", "9.9 %", fmt::format("{:.2f} %", error),
        "the paper cuts the decimals off. Here cells beyond an edge repeat the cell nearest to where they "
        "lie, the triangle across being turned into the plane: growth then takes 0.98 of the true time or "
        "more whatever the angle, as on a flat grid"}});
}

void figure_of_layers(FigurePage& page) {
  const auto panel = [](const std::string& title, double first, double second) {
    Plot plot{title, "depth x", "light", {}, {}};
    const double from[] = {0.0, first, first + second, 5.0};
    const char* names[] = {"upper layer", "lower layer", "nothing more"};
    const Rgba8 colours[] = {{22, 128, 112, 255}, {178, 84, 38, 255}, {150, 154, 160, 255}};
    for (std::size_t part = 0; part < 3; ++part) {
      PlotCurve curve{names[part], {}, colours[part]};
      for (int k = 0; k <= 100; ++k) {
        const double x = from[part] + (from[part + 1] - from[part]) * k / 100.0;
        curve.points.emplace_back(x, std::exp(-x));
      }
      // The area under its part of the curve is the weight of a layer.
      for (double x = from[part] + 0.02; part < 2 && x < from[part + 1]; x += 0.04)
        plot.curves.push_back(
            {"", {{x, 0.0}, {x, std::exp(-x)}}, {colours[part].r, colours[part].g, colours[part].b, 60}});
      plot.curves.push_back(curve);
    }
    plot.x_low = 0.0;
    plot.x_high = 5.0;
    plot.y_low = 0.0;
    plot.y_high = 1.0;
    return draw_plot(plot, 760, 560);
  };
  page.section(
      "Figure 21: light through two layers",
      "Light falls off as e<sup>-x</sup>; the area over a layer is its weight in the mixture. In (b) each "
      "thickness is multiplied by 1 / (1 - opacity): 0.5 above, 0.2 below.");
  page.figure(
      "figure-21",
      {{"(a) thicknesses 0.6 and 1.2", panel("", 0.6, 1.2)}, {"(b) with opacities", panel("", 1.2, 1.5)}}, 2);
  page.table({{"regrouped formula", "(l1 - l2) e<sup>-a</sup>", "(l2 - l1) e<sup>-a</sup>",
               "what follows from the paper's own integral; any number of layers, the metal below them "
               "without end"}});
}

void add_figures(CLI::App& app) {
  auto out = std::make_shared<std::string>("figures");
  auto* command = app.add_subcommand("figures", "Draw the figures of the 1999 paper again, on one page");
  command->add_option("OUT", *out, "Directory for index.html and its pictures; made if need be")
      ->capture_default_str();
  command->footer("The page says the paper's numbers beside those found here. It needs no other file.");
  command->callback([out] {
    make_directory(*out);
    Progress progress(true);
    FigurePage page(*out);
    using Figure = void (*)(FigurePage&);
    const std::pair<const char*, Figure> figures[] = {
        {"figure 2", figure_of_the_cup}, {"figure 8", figure_of_orientation},
        {"figure 10", figure_of_discs},  {"figures 16 and 17", figures_of_regions},
        {"figure 21", figure_of_layers}, {"figures 22 and 23", figures_of_patina}};
    page.section(
        "Surface cellular automata: the figures of the paper again",
        "S. Gobron and N. Chiba, <i>3D Surface Cellular Automata and Their Applications</i>, Journal of "
        "Visualization and Computer Animation, 1999. The models are our own, of the same kind and size. The "
        "paper's times are of a 175 MHz R10000 of 1996; times here are of the processor, on one thread or "
        "summed over all.");
    for (const auto& [name, figure] : figures) {
      progress.stage(name);
      figure(page);
    }
    page.write();
    progress.finish();
    fmt::print("in {}: index.html\n", *out);
  });
}
