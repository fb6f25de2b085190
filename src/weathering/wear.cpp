// Wear: what weather erodes and hands polish.
#include <algorithm>
#include <cmath>

#include "cells.hpp"
#include "entries.hpp"
#include "verdigris/exposure/curvature.hpp"

namespace verdigris::weathering {

namespace {

// Takes depth(slot) off coats `lowest` and above, then `into_metal` of what is left off the metal.
template <typename Depth>
OperatorReport wear(CoatedMetal& metal, const OperatorSetup& setup, double into_metal, bool brighten,
                    std::size_t lowest, Depth&& depth) {
  const Surface& surface = setup.surface;
  Field<float> taken(surface.slot_count(), 0.0f), cut(surface.slot_count(), 0.0f);
  for_owned(surface, [&](std::uint32_t slot) {
    const auto asked = static_cast<float>(depth(slot));
    if (!(asked > 0.0f)) return;
    taken[slot] = take_off(metal, slot, asked, lowest);
    const float rest = asked - taken[slot];
    if (!(rest > 0.0f)) return;
    const float metal_left = std::max(0.0f, static_cast<float>(metal.metal.thickness) - metal.loss[slot]);
    cut[slot] = std::min(metal_left, rest * static_cast<float>(into_metal));
    metal.loss[slot] += cut[slot];
    // Nothing is left on the metal: it shines and starts anew.
    if (brighten) {
      metal.corroded[slot] = -1.0f;
      metal.damage[slot] = 0.0f;
    }
  });
  OperatorReport report;
  each_owned(surface, [&](std::uint32_t slot) {
    report.removed += static_cast<double>(taken[slot]);
    report.metal += static_cast<double>(cut[slot]);
    report.cells += taken[slot] > 0.0f || cut[slot] > 0.0f;
  });
  return report;
}

struct Erode {
  static constexpr const char *name = "erode",
                              *summary = "wears coats down, the uppermost first, then the metal";
  static std::vector<std::string> masks() { return {"where"}; }
  double depth = 10.0, unevenness = 0.3, into_metal = 0.0;
  std::string down_to;

  template <typename V>
  void parameters(V&& v) {
    v("depth", depth, 0.0, 1e6, "um", "taken where the mask is 1");
    v("unevenness", unevenness, 0.0, 1.0, "1", "random share of the depth, cell by cell");
    v("into_metal", into_metal, 0.0, 1.0, "1", "share of what coats do not give that the metal does");
    v("down_to", down_to, {}, "the lowest coat that wears; empty: all, and the metal");
  }
  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Field<float>* where = setup.mask("where");
    const std::size_t lowest = down_to.empty() ? 0 : find_coat(metal, down_to, "erode");
    return wear(metal, setup, down_to.empty() ? into_metal : 0.0, false, lowest, [&](std::uint32_t slot) {
      const double u = uniform(setup.seed, 0, slot, 0x57454152);
      return depth * OperatorSetup::at(where, slot) * (1.0 - unevenness * u);
    });
  }
};

struct Polish {
  static constexpr const char *name = "polish",
                              *summary =
                                  "rubs coats and patina off, convex parts first, down to bright metal";
  static std::vector<std::string> masks() { return {"where"}; }
  double depth = 20.0, softness = 1.0, radius = 0.0, into_metal = 0.0;

  template <typename V>
  void parameters(V&& v) {
    v("depth", depth, 0.0, 1e6, "um", "taken where the surface is most convex, or the mask 1");
    v("softness", softness, 0.05, 10.0, "1", "below 1 the cloth reaches flat parts too, above 1 only edges");
    v("radius", radius, 0.0, 1e9, "model units", "over which the surface bends; 0: what suits the model");
    v("into_metal", into_metal, 0.0, 1.0, "1", "share of what coats do not give that the metal does");
  }
  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    Field<float> convex;
    const Field<float>* where = setup.mask("where");
    if (where == nullptr) {
      convex = convexity(setup.surface, radius > 0.0 ? radius : default_radius(setup.surface));
      where = &convex;
    }
    return wear(metal, setup, into_metal, true, 0, [&](std::uint32_t slot) {
      return depth * std::pow(OperatorSetup::at(where, slot), softness);
    });
  }
};

}  // namespace

void add_wear(OperatorCatalogue& catalogue) {
  catalogue.add<Erode>();
  catalogue.add<Polish>();
}

}  // namespace verdigris::weathering
