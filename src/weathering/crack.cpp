// Cracks in a coat, as an operator.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cells.hpp"
#include "entries.hpp"
#include "verdigris/weathering/crack_network.hpp"

namespace verdigris::weathering {

namespace {

struct Crack {
  static constexpr const char *name = "crack",
                              *summary =
                                  "cracks a coat all over: glaze, old paint; stress leaves along the cracks";
  static std::vector<std::string> masks() { return {"strain"}; }
  std::string layer;
  double spacing = 0.06, width = 1.5, depth = 1e4, wander = 0.25, loosens = 0.3;

  template <typename V>
  void parameters(V&& v) {
    v("layer", layer, {}, "the coat that cracks, with those above it; empty: the uppermost");
    v("spacing", spacing, 1e-4, 10.0, "1",
      "between cracks, in parts of the model's longest side; where the mask is 1");
    v("width", width, 0.5, 50.0, "cells", "of a crack");
    v("depth", depth, 0.0, 1e6, "um", "of a crack; it ends at the bottom of the coat");
    v("wander", wander, 0.0, 3.0, "rad", "how far a crack turns at random on a way of the spacing");
    v("loosens", loosens, 0.0, 1.0, "1", "share of the coat's bond lost beside a crack");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Surface& surface = setup.surface;
    const std::size_t lowest = find_coat(metal, layer, "crack");
    const Bounds bounds = mesh_bounds(surface.mesh());
    const glm::dvec3 size = bounds.upper - bounds.lower;
    Field<float> strain =
        setup.mask("strain") != nullptr ? *setup.mask("strain") : Field<float>(surface.slot_count(), 1.0f);
    // What is not there cannot crack.
    Coat& coat = metal.coats[lowest];
    for (std::size_t s = 0; s < strain.size(); ++s)
      if (!(coat.thickness[s] > bare_below)) strain[s] = 0.0f;
    CrackSettings settings;
    settings.spacing = spacing * std::max({size.x, size.y, size.z});
    settings.wander = wander;
    settings.seed = setup.seed;
    const CrackNetwork network = grow_cracks(surface, settings, strain);

    if (coat.adhesion.empty()) coat.adhesion.assign(surface.slot_count(), 1.0f);
    const auto reach = static_cast<float>(0.25 * settings.spacing / surface.cell_size());
    OperatorReport report;
    each_owned(surface, [&](std::uint32_t slot) {
      const float d = network.distance[slot];
      if (strain[slot] <= 0.0f) return;
      coat.adhesion[slot] *= 1.0f - static_cast<float>(loosens) * std::exp(-d / reach);
      if (2.0f * d >= static_cast<float>(width)) return;
      ++report.cells;
      metal.damage[slot] = 1.0f;
      report.removed += static_cast<double>(take_off(metal, slot, static_cast<float>(depth), lowest));
    });
    report.numbers = {
        {"cracks", static_cast<double>(network.cracks)},
        {"crack_length", network.length},
        {"junctions_of_three", static_cast<double>(network.junctions[0])},
        {"junctions_of_more", static_cast<double>(network.junctions[1] + network.junctions[2])}};
    return report;
  }
};

}  // namespace

void add_crack(OperatorCatalogue& catalogue) {
  catalogue.add<Crack>();
}

}  // namespace verdigris::weathering
