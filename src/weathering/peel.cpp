// Peeling: a coat delaminates from its defects, breaks into flakes, and flakes fall off whole.
#include <algorithm>
#include <cmath>

#include "cells.hpp"
#include "distance.hpp"
#include "entries.hpp"
#include "verdigris/automaton/simulation.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/weathering/delamination.hpp"

namespace verdigris::weathering {

namespace {

constexpr std::uint32_t tough_purpose = 0x50454502, defect_purpose = 0x50454503, fall_purpose = 0x50454504;

struct Peel {
  static constexpr const char *name = "peel",
                              *summary = "lets a coat come loose from its defects and fall off in flakes";
  static std::vector<std::string> masks() { return {"where"}; }
  std::string layer;
  double stress = 2.6, spread = 0.35, defects = 0.0, flake = 12.0, fall = 0.7;
  std::uint64_t steps = 60;

  template <typename V>
  void parameters(V&& v) {
    v("layer", layer, {}, "the coat that peels, with those above it; empty: the uppermost");
    v("stress", stress, 0.0, 1e3, "1",
      "against a bond of 1, for a coat of its mean thickness; 2.8 moves straight fronts");
    v("spread", spread, 0.0, 1.0, "1", "how much the bond differs from cell to cell");
    v("defects", defects, 0.0, 1.0, "1", "share of cells with a new defect, beside bare ones");
    v("steps", steps, 0.0, 1e6, "1", "how far fronts may go, in half cells");
    v("flake", flake, 1.0, 1e4, "cells", "size of a flake: the square root of its area");
    v("fall", fall, 0.0, 1.0, "1", "share of the loose flakes that fall; others hang on, unbonded");
  }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Surface& surface = setup.surface;
    const std::size_t lowest = find_coat(metal, layer, "peel");
    OperatorReport report;
    const auto state = delaminate(metal.coats[lowest], setup, report);
    const Field<std::int32_t> flakes = break_up(setup, state);
    Coat& coat = metal.coats[lowest];
    if (coat.adhesion.empty()) coat.adhesion.assign(surface.slot_count(), 1.0f);
    std::int32_t count = 0;
    std::uint64_t loose = 0;
    each_owned(surface, [&](std::uint32_t slot) {
      if (state[slot] != DelaminationRule::loose) return;
      ++loose;
      const std::int32_t flake_here = flakes[slot];
      count = std::max(count, flake_here + 1);
      if (flake_here < 0 || !falls(setup, flake_here)) {
        coat.adhesion[slot] *= 0.5f;
        return;
      }
      ++report.cells;
      for (std::size_t k = lowest; k < metal.coats.size(); ++k) {
        report.removed += static_cast<double>(metal.coats[k].thickness[slot]);
        metal.coats[k].thickness[slot] = 0.0f;
      }
      metal.damage[slot] = 0.0f;
    });
    report.numbers = {{"loose_cells", static_cast<double>(loose)}, {"flakes", static_cast<double>(count)}};
    return report;
  }

  bool falls(const OperatorSetup& setup, std::int32_t flake_here) const {
    return uniform(setup.seed, 3, static_cast<std::uint32_t>(flake_here), fall_purpose) < fall;
  }

  Field<DelaminationRule::State> delaminate(const Coat& coat, const OperatorSetup& setup,
                                            OperatorReport& report) const {
    const Surface& surface = setup.surface;
    const Field<float>* mask = setup.mask("where");
    double sum = 0.0;
    std::uint64_t coated = 0;
    each_owned(surface, [&](std::uint32_t slot) {
      if (coat.thickness[slot] < bare_below) return;
      sum += static_cast<double>(coat.thickness[slot]);
      ++coated;
    });
    const double mean = coated > 0 ? sum / static_cast<double>(coated) : 1.0;
    const std::size_t slots = surface.slot_count();
    Field<float> pull(slots, 0.0f), tough(slots, 1.0f);
    Field<DelaminationRule::State> state(slots, DelaminationRule::outside_state);
    for_owned(surface, [&](std::uint32_t slot) {
      const double thickness = static_cast<double>(coat.thickness[slot]);
      const double bond = coat.adhesion.empty() ? 1.0 : static_cast<double>(coat.adhesion[slot]);
      pull[slot] = static_cast<float>(stress * OperatorSetup::at(mask, slot) * thickness / mean);
      tough[slot] = static_cast<float>(
          bond * (1.0 + spread * (2.0 * uniform(setup.seed, 1, slot, tough_purpose) - 1.0)) + 1e-6);
      const bool defect = uniform(setup.seed, 2, slot, defect_purpose) < defects;
      state[slot] = thickness < static_cast<double>(bare_below) ? DelaminationRule::bare
                    : defect                                    ? DelaminationRule::loose
                                                                : DelaminationRule::bonded;
    });
    Simulation<DelaminationRule> run(surface, DelaminationRule{pull, tough}, std::move(state), setup.seed);
    // A cell that can go stays with a chance of a half: many steps without a change are the end.
    int still = 0;
    for (std::uint64_t k = 0; k < steps && still < 32 && !run.finished(); ++k) {
      still = run.step().changed == 0 ? still + 1 : 0;
      if (setup.go_on(static_cast<double>(k) / static_cast<double>(steps))) continue;
      report.complete = false;
      break;
    }
    return run.state();
  }

  // [slot] the flake that a loose cell belongs to; -1: none. Loose regions break where growth from points a
  // flake apart meets.
  Field<std::int32_t> break_up(const OperatorSetup& setup,
                               const Field<DelaminationRule::State>& state) const {
    const Surface& surface = setup.surface;
    std::uint64_t loose = 0;
    Field<std::uint8_t> barrier(surface.slot_count(), 1);
    each_owned(surface, [&](std::uint32_t slot) {
      barrier[slot] = state[slot] != DelaminationRule::loose;
      loose += barrier[slot] == 0;
    });
    if (loose == 0) return Field<std::int32_t>(surface.slot_count(), -1);
    const auto count = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::llround(static_cast<double>(loose) / (flake * flake))));
    SimulationSetup growth{surface, setup.seed};
    growth.seeds = random_seeds(surface, count, setup.seed, barrier);
    growth.barrier = std::move(barrier);
    const auto voronoi = voronoi_entry().create(growth, {});
    while (!voronoi->finished()) voronoi->step();
    Field<std::int32_t> flakes = voronoi->field("label");
    name_the_rest(surface, state, static_cast<std::int32_t>(count), flakes);
    return flakes;
  }

  // Regions that no point fell into are a flake each.
  static void name_the_rest(const Surface& surface, const Field<DelaminationRule::State>& state,
                            std::int32_t next, Field<std::int32_t>& flakes) {
    const std::vector<std::uint32_t> owners = owners_of(surface);
    std::vector<std::uint32_t> queue;
    const auto take = [&](std::uint32_t slot) {
      if (slot == no_owner || state[slot] != DelaminationRule::loose || flakes[slot] >= 0) return;
      flakes[slot] = next;
      queue.push_back(slot);
    };
    each_owned(surface, [&](std::uint32_t first) {
      take(first);
      if (queue.empty()) return;
      for (std::size_t k = 0; k < queue.size(); ++k)
        for (const std::uint32_t n : around(surface, queue[k])) take(owners[n]);
      queue.clear();
      ++next;
    });
  }
};

}  // namespace

void add_peel(OperatorCatalogue& catalogue) {
  catalogue.add<Peel>();
}

}  // namespace verdigris::weathering
