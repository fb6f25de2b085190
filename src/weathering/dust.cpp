// Dust and stains: what comes from elsewhere and lies on top.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "cells.hpp"
#include "entries.hpp"
#include "hex_colour.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/curvature.hpp"
#include "verdigris/exposure/lie.hpp"
#include "verdigris/exposure/openness.hpp"
#include "verdigris/exposure/soften.hpp"
#include "verdigris/exposure/water.hpp"

namespace verdigris::weathering {

namespace {

// The loose coat of that name and look while none but loose ones lie on it; else a new one on top, numbered
// when the name is taken.
Coat& loose_coat(CoatedMetal& metal, Layer layer) {
  const std::string base = layer.name;
  auto latest = metal.coats.end();
  for (int number = 2;; ++number) {
    const auto found = std::find_if(metal.coats.begin(), metal.coats.end(),
                                    [&](const Coat& coat) { return coat.layer.name == layer.name; });
    if (found == metal.coats.end()) break;
    latest = found;
    layer.name = fmt::format("{} {}", base, number);
  }
  const auto is_loose = [](const Coat& coat) { return coat.kind == CoatKind::loose; };
  const auto looks_alike = [&](const Layer& other) {
    return other.finish.colour == layer.finish.colour && other.opacity == layer.opacity &&
           other.unit == layer.unit;
  };
  if (latest != metal.coats.end() && looks_alike(latest->layer) &&
      std::all_of(latest, metal.coats.end(), is_loose))
    return *latest;
  metal.coats.push_back({std::move(layer), CoatKind::loose, Field<float>(metal.loss.size(), 0.0f), {}});
  return metal.coats.back();
}

struct Dust {
  static constexpr const char *name = "dust",
                              *summary = "lets dust or soot fall; it settles on what faces up and in hollows";
  static std::vector<std::string> masks() { return {"where"}; }
  std::string layer = "dust", colour = "#7d7363";
  double amount = 10.0, repose = 35.0, hollows = 0.5, cling = 0.0, opacity = 0.3, unit = 12.0;

  template <typename V>
  void parameters(V&& v) {
    v("layer", layer, {}, "its name");
    v("colour", colour, {}, "\"#rrggbb\"");
    v("amount", amount, 0.0, 1e5, "um", "that falls on level ground under the open sky");
    v("repose", repose, 1.0, 89.0, "degrees", "slope on which half of what arrives in a cell slides on");
    v("hollows", hollows, 0.0, 1.0, "1", "share that hollows, cracks and scratches hold on any slope");
    v("cling", cling, 0.0, 1.0, "1",
      "share of what the air brings to any place, underneath too, and sticks there: soot");
    v("opacity", opacity, 0.0, 0.999, "1", "how little light passes");
    v("unit", unit, 1e-6, 1e6, "um", "thickness that counts as 1 for the light");
  }

  void check() const {
    if (layer.empty()) throw InputError("dust", "it has no name", "write layer = \"dust\"");
    colour_of(colour, "dust");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    check();
    const Surface& surface = setup.surface;
    Layer look;
    look.name = layer;
    look.finish = {colour_of(colour, "dust"), 1.0f, 0.0f, 0.0f, 1.0f};
    look.opacity = opacity;
    look.unit = unit;
    look.density = 1.2;
    Coat& coat = loose_coat(metal, look);
    ExposureCache own(surface);
    ExposureCache& exposures = setup.exposures != nullptr ? *setup.exposures : own;
    const Field<float>& sky = exposures.sky_view(setup.up, {.rays = 64});
    const Field<float> slope = slope_mask(surface, setup.up);
    const Field<float> hollow = concavity(surface, default_radius(surface));
    const WaterPaths& paths = exposures.water_paths({.up = setup.up});
    const Field<float>* where = setup.mask("where");
    OperatorReport report;
    Field<float> laid(surface.slot_count(), 0.0f);
    std::vector<double> arrived(paths.cells.size(), 0.0);
    double fallen = 0.0, lost = 0.0, kept = 0.0;
    // From the highest cell to the lowest: what does not stay goes the way of water.
    for (std::size_t k = 0; k < paths.cells.size(); ++k) {
      const std::uint32_t slot = paths.slots[k];
      const double level = std::max(0.0, std::cos(static_cast<double>(slope[slot]) * 1.5707963267948966));
      const double all = amount * OperatorSetup::at(where, slot);
      const double falls = (1.0 - cling) * all * level * static_cast<double>(sky[slot]);
      fallen += falls + cling * all;
      const double here = arrived[k] + falls;
      const double angle = 90.0 * static_cast<double>(slope[slot]);
      const double rough =
          std::max(static_cast<double>(hollow[slot]), static_cast<double>(metal.damage[slot]));
      const double holds = std::max(1.0 / (1.0 + std::exp((angle - repose) / 4.0)), hollows * rough);
      double stays = here * holds, slides = here - stays;
      stays += cling * all;
      const auto& cell = paths.cells[k];
      const auto give = [&](std::uint32_t to, double much) {
        if (to == WaterPaths::stays)
          stays += much;
        else if (to == WaterPaths::dripped || to == WaterPaths::drained)
          lost += much;
        else
          arrived[to] += much;
      };
      if (cell.drip_share > 0.0f) {
        const double drips = slides * static_cast<double>(cell.drip_share);
        give(cell.drip_to, drips);
        slides -= drips;
      }
      // The first way gets the rest, so that none is lost to rounding.
      double rest = slides;
      for (std::size_t i = 3; i > 0; --i) {
        if (!(cell.share[i] > 0.0f)) continue;
        const double much = slides * static_cast<double>(cell.share[i]);
        give(cell.to[i], much);
        rest -= much;
      }
      give(cell.to[0], rest);
      laid[slot] = static_cast<float>(stays);
      kept += stays;
    }
    // What slides goes in steps of more than a cell: it lies where it passed too, and is as much as before.
    constexpr int passes = 2;
    soften(surface, laid, passes);
    double sum = 0.0;
    each_owned(surface, [&](std::uint32_t slot) { sum += static_cast<double>(laid[slot]); });
    const double scale = sum > 0.0 ? kept / sum : 0.0;
    each_owned(surface, [&](std::uint32_t slot) {
      const double stays = scale * static_cast<double>(laid[slot]);
      coat.thickness[slot] += static_cast<float>(stays);
      report.added += stays;
      report.cells += stays > 0.0;
    });
    report.numbers = {{"fallen_um", fallen / static_cast<double>(surface.owned_count())},
                      {"lost_um", lost / static_cast<double>(surface.owned_count())}};
    return report;
  }
};

struct Stain {
  static constexpr const char *name = "stain",
                              *summary = "lets rain wash corrosion products down and leave streaks";
  static std::vector<std::string> masks() { return {"source"}; }
  std::string layer;
  double amount = 3.0, most = 40.0, reach = 0.25, meander = 12.0, gusts = 20.0, source_from = 2.0;
  double meander_size = 0.0;

  template <typename V>
  void parameters(V&& v) {
    v("layer", layer, {}, "the product that is washed off; empty: the uppermost one");
    v("amount", amount, 0.0, 1e4, "um", "mean thickness laid down, over cells that have any");
    v("most", most, 0.0, 1e5, "um", "greatest thickness of the stain; what comes more is washed off");
    v("reach", reach, 1e-3, 100.0, "1", "in which water lays down 63 %, in parts of the model's diagonal");
    v("meander", meander, 0.0, 60.0, "degrees", "how far roughness turns water aside; it makes rivulets");
    v("meander_size", meander_size, 0.0, 1e9, "model units", "size of that roughness; 0: twelve cells");
    v("gusts", gusts, 0.0, 89.0, "degrees", "half the opening of the cone that rain comes in");
    v("source_from", source_from, 0.0, 1e5, "um", "thickness of bare product that gives all it can");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Surface& surface = setup.surface;
    const std::size_t product = find_product(metal);
    const Field<float>* given = setup.mask("source");
    Field<float> source(surface.slot_count(), 0.0f);
    for_owned(surface, [&](std::uint32_t slot) {
      const double bare = std::exp(-static_cast<double>(cover(metal, slot)) / 5.0);
      const double much = static_cast<double>(metal.coats[product].thickness[slot]);
      source[slot] = static_cast<float>(bare * std::min(1.0, much / std::max(source_from, 1e-9)) *
                                        OperatorSetup::at(given, slot));
    });
    ExposureCache own(surface);
    ExposureCache& exposures = setup.exposures != nullptr ? *setup.exposures : own;
    const Field<float>& rain = exposures.rain_exposure({setup.up, gusts}, {.rays = 64});
    WaterPathSettings way{.up = setup.up, .meander = meander, .meander_size = meander_size};
    way.seed = setup.seed;
    const WaterPaths paths = make_water_paths(surface, way);
    const Bounds bounds = mesh_bounds(surface.mesh());
    StormSettings storm;
    storm.deposit_length = reach * glm::length(bounds.upper - bounds.lower);
    storm.film = 0.0;
    const WaterResult water = run_water(surface, paths, rain, source, storm);

    Layer layer_of_stain = metal.coats[product].layer;
    layer_of_stain.name += " stain";
    double sum = 0.0;
    std::uint64_t stained = 0;
    each_owned(surface, [&](std::uint32_t slot) {
      sum += static_cast<double>(water.stain[slot]);
      stained += water.stain[slot] > 0.0f;
    });
    OperatorReport report;
    report.cells = stained;
    Coat& coat = loose_coat(metal, layer_of_stain);
    const double scale = sum > 0.0 ? amount * static_cast<double>(stained) / sum : 0.0;
    each_owned(surface, [&](std::uint32_t slot) {
      const double room = std::max(0.0, most - static_cast<double>(coat.thickness[slot]));
      const double laid = std::min(room, scale * static_cast<double>(water.stain[slot]));
      coat.thickness[slot] += static_cast<float>(laid);
      report.added += laid;
    });
    report.numbers.emplace_back("carried_off", water.balance.dissolved > 0.0
                                                   ? water.balance.carried_off / water.balance.dissolved
                                                   : 0.0);
    return report;
  }

  std::size_t find_product(const CoatedMetal& metal) const {
    if (!layer.empty()) return find_coat(metal, layer, "stain");
    for (std::size_t k = metal.coats.size(); k-- > 0;)
      if (metal.coats[k].kind == CoatKind::product) return k;
    throw InputError("stain", "the metal has no products of corrosion", "choose another material");
  }
};

}  // namespace

void add_dust(OperatorCatalogue& catalogue) {
  catalogue.add<Dust>();
}
void add_stain(OperatorCatalogue& catalogue) {
  catalogue.add<Stain>();
}

}  // namespace verdigris::weathering
