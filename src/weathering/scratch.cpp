// Scratches: straight or slightly bent lines cut through the coats.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "cells.hpp"
#include "distance.hpp"
#include "entries.hpp"
#include "line_walk.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"

namespace verdigris::weathering {

namespace {

constexpr std::uint32_t scratch_purpose = 0x53435201;

// The longest side of the model.
double extent(const Surface& surface) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  const glm::dvec3 size = bounds.upper - bounds.lower;
  return std::max({size.x, size.y, size.z});
}

struct Scratch {
  static constexpr const char *name = "scratch", *summary = "cuts lines through the coats at random places";
  static std::vector<std::string> masks() { return {"where"}; }
  std::uint64_t count = 12;
  double length = 0.15, depth = 200.0, bend = 0.2, width = 1.0;

  template <typename V>
  void parameters(V&& v) {
    v("count", count, 0.0, 1e6, "1", "how many, fewer where the mask is below 1");
    v("length", length, 0.0, 100.0, "1", "of each, at most, in parts of the model's longest side");
    v("depth", depth, 0.0, 1e6, "um", "of the cut in its middle; it is shallower towards the ends");
    v("bend", bend, 0.0, 10.0, "rad", "how far one turns on its way");
    v("width", width, 0.5, 50.0, "cells", "of the cut, one cell at least");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Surface& surface = setup.surface;
    const Unfolding unfolding(surface.frames(), surface.adjacency(), surface.barred_edges());
    const Field<float>* where = setup.mask("where");
    const std::vector<std::uint32_t> owners = owners_of(surface);
    const auto half = static_cast<float>(0.5 * width);
    Field<float> cut(surface.slot_count(), 0.0f), press(surface.slot_count(), 0.0f),
        distance(surface.slot_count(), half);
    const double longest = length * extent(surface), step = 0.4 * surface.cell_size();
    const std::size_t most = std::min<std::size_t>(count, surface.owned_count());
    const auto starts = most > 0 ? random_seeds(surface, most, setup.seed) : std::vector<Seed>{};
    std::uint64_t drawn = 0;
    std::vector<std::uint32_t> line, touched;
    bool complete = true;
    for (std::uint32_t k = 0; k < starts.size(); ++k) {
      complete = setup.go_on(static_cast<double>(k) / static_cast<double>(starts.size()));
      if (!complete) break;
      const auto w = CellRandom(setup.seed, 1, k).words(scratch_purpose);
      const auto u = [&](std::size_t i) { return w[i] / 4294967296.0; };
      if (u(0) >= OperatorSetup::at(where, starts[k].slot)) continue;
      ++drawn;
      const double size = longest * (0.3 + 0.7 * u(1));
      line.clear();
      LineWalk walk(surface, unfolding, starts[k].slot, 2.0 * std::numbers::pi * u(2));
      for (double s = 0.0; s <= size; s += step) {
        const auto here = static_cast<float>(depth * std::min(1.0, 4.0 * std::min(s, size - s) / size + 0.2));
        if (const auto cell = walk.cell()) {
          if (line.empty() || line.back() != *cell) line.push_back(*cell);
          press[*cell] = std::max(press[*cell], here);
        }
        walk.turn(bend * (2.0 * u(3) - 1.0) * step / std::max(size, step));
        if (!walk.forward(step)) break;
      }
      // A cut is as deep beside its line as on it.
      touched.clear();
      carry_distance(surface, owners, line, distance, [&](std::uint32_t slot, std::uint32_t from) {
        press[slot] = press[from];
        touched.push_back(slot);
      });
      for (const std::uint32_t slot : touched) cut[slot] = std::max(cut[slot], press[slot]);
      for (const std::uint32_t slot : touched) press[slot] = 0.0f, distance[slot] = half;
    }
    OperatorReport report;
    report.complete = complete;
    each_owned(surface, [&](std::uint32_t slot) {
      if (!(cut[slot] > 0.0f)) return;
      ++report.cells;
      report.removed += static_cast<double>(take_off(metal, slot, cut[slot]));
      metal.damage[slot] = std::max(metal.damage[slot], 1.0f);
    });
    report.numbers.emplace_back("scratches", static_cast<double>(drawn));
    return report;
  }
};

}  // namespace

void add_scratch(OperatorCatalogue& catalogue) {
  catalogue.add<Scratch>();
}

}  // namespace verdigris::weathering
