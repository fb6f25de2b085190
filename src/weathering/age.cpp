// Years of weather: corrosion spreads where the metal is bare or its coat thin, and grows by the material's
// laws.
#include <algorithm>
#include <cmath>
#include <string>

#include "cells.hpp"
#include "entries.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"

namespace verdigris::weathering {

namespace {

constexpr std::uint32_t onset_purpose = 0x41474501;

struct Age {
  static constexpr const char *name = "age", *summary = "lets the metal corrode for some years";
  static std::vector<std::string> masks() { return {"wetness", "seeding"}; }
  std::string exposure = "C3";
  double years = 10.0, spread = 0.0, spots = 20.0, onset = 1.0;
  double hold = 20.0, creep = 0.88, under = 0.4, lift = 15.0;

  template <typename V>
  void parameters(V&& v) {
    v("class", exposure, {"C1", "C2", "C3", "C4", "C5", "CX"}, "corrosivity of the air, ISO 9223");
    v("years", years, 0.0, 1e4, "years", "how long");
    v("spread", spread, 0.0, 100.0, "1/year",
      "how far spots grow a year, in parts of the longest side; 0: bare metal tarnishes everywhere");
    v("spots", spots, 0.0, 1e9, "1/year", "new spots a year, were all metal bare");
    v("onset", onset, 0.0, 1e3, "years", "by which every place has begun to tarnish, when spread is 0");
    v("hold", hold, 1e-3, 1e6, "um", "of a coat that let 37 % of the weather through");
    v("creep", creep, 0.0, 1.0, "1", "share of an attack that reaches metal under a sound coat from beside");
    v("under", under, 0.0, 1.0, "1", "speed of corrosion under a coat, against bare metal");
    v("lift", lift, 1e-3, 1e6, "um", "of product that breaks 63 % of the bond of a coat above it");
  }

  double duration() const { return years; }

  OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup) const {
    const Surface& surface = setup.surface;
    Field<float> open(surface.slot_count(), 0.0f);
    for_owned(surface, [&](std::uint32_t slot) {
      open[slot] = static_cast<float>(std::exp(-static_cast<double>(cover(metal, slot)) / hold));
    });
    for (Coat& coat : metal.coats)
      if (coat.kind == CoatKind::applied && coat.adhesion.empty())
        coat.adhesion.assign(surface.slot_count(), 1.0f);
    OperatorReport report;
    report.years = years;
    const Field<float> time = spread > 0.0 ? years_in_spots(metal, setup, open, report)
                                           : years_everywhere(metal, setup, open, report);
    corrode(metal, surface, time, report);
    return report;
  }

  // Lets each cell corrode for its time.
  void corrode(CoatedMetal& metal, const Surface& surface, const Field<float>& time,
               OperatorReport& report) const {
    const ExposureClass air = exposure_class_named(exposure);
    Field<float> lost(surface.slot_count(), 0.0f), grown(surface.slot_count(), 0.0f);
    for_owned(surface, [&](std::uint32_t slot) {
      if (!(time[slot] >= 0.0f)) return;
      const double before = std::max(0.0, static_cast<double>(metal.corroded[slot]));
      const double after = before + static_cast<double>(time[slot]);
      grow(metal, slot, air, before, after, lost[slot], grown[slot]);
      metal.corroded[slot] = static_cast<float>(after);
    });
    each_owned(surface, [&](std::uint32_t slot) {
      report.metal += static_cast<double>(lost[slot]);
      report.added += static_cast<double>(grown[slot]);
      report.cells += time[slot] >= 0.0f;
    });
  }

  // The state of a moment: as it will be after the whole, with the time that has passed.
  void show(const CoatedMetal& metal, const OperatorSetup& setup, std::size_t moment,
            const Field<float>& time) const {
    CoatedMetal then = metal;
    OperatorReport ignored;
    corrode(then, setup.surface, time, ignored);
    setup.show(moment, then);
  }

  // What the laws add between two ages.
  void grow(CoatedMetal& metal, std::uint32_t slot, ExposureClass air, double before, double after,
            float& lost, float& grown) const {
    const double loss = thickness(metal.metal.loss, air, after) - thickness(metal.metal.loss, air, before);
    const float left = std::max(0.0f, static_cast<float>(metal.metal.thickness) - metal.loss[slot]);
    lost = std::min(left, static_cast<float>(loss));
    metal.loss[slot] += lost;
    for (Coat& coat : metal.coats) {
      if (coat.kind != CoatKind::product) {
        if (coat.kind == CoatKind::applied && coat.thickness[slot] >= bare_below && grown > 0.0f) {
          // Rust takes more room than its iron: it lifts what lies on it.
          coat.adhesion[slot] *= std::exp(-grown / static_cast<float>(lift));
        }
        continue;
      }
      const GrowthLaw& law = coat.layer.growth;
      const auto more =
          static_cast<float>(std::max(0.0, thickness(law, air, after) - thickness(law, air, before)));
      coat.thickness[slot] += more;
      grown += more;
    }
  }

  // Time that a cell spends corroding: wet years, fewer under a coat.
  double effective(const Field<float>* wet, const Field<float>& open, std::uint32_t slot, double time) const {
    const double bare = static_cast<double>(open[slot]);
    return time * OperatorSetup::at(wet, slot) * (under + (1.0 - under) * bare);
  }

  // [slot] years, -1: sound. Bare metal tarnishes everywhere, each cell from its own time on.
  Field<float> years_everywhere(const CoatedMetal& metal, const OperatorSetup& setup,
                                const Field<float>& open, OperatorReport& report) const {
    for (std::size_t k = 0; k < setup.moments.size(); ++k) {
      show(metal, setup, k, years_until(metal, setup, open, setup.moments[k] * years));
      if (setup.go_on(setup.moments[k])) continue;
      report.complete = false;
      report.years = setup.moments[k] * years;
      break;
    }
    return years_until(metal, setup, open, report.years);
  }

  Field<float> years_until(const CoatedMetal& metal, const OperatorSetup& setup, const Field<float>& open,
                           double now) const {
    const Field<float>*wet = setup.mask("wetness"), *seeding = setup.mask("seeding");
    Field<float> time(setup.surface.slot_count(), -1.0f);
    for_owned(setup.surface, [&](std::uint32_t slot) {
      const bool begun = metal.corroded[slot] >= 0.0f;
      if (!begun && static_cast<double>(open[slot]) * OperatorSetup::at(seeding, slot) < 0.2) return;
      const double waits = begun ? 0.0 : onset * uniform(setup.seed, 0, slot, onset_purpose);
      if (now > waits) time[slot] = static_cast<float>(effective(wet, open, slot, now - waits));
    });
    return time;
  }

  // The same by the strategic automaton: spots start on bare metal and spread, slowly under coats.
  Field<float> years_in_spots(CoatedMetal& metal, const OperatorSetup& setup, const Field<float>& open,
                              OperatorReport& report) const {
    const Surface& surface = setup.surface;
    const Field<float>*wet = setup.mask("wetness"), *seeding = setup.mask("seeding");
    const Bounds bounds = mesh_bounds(surface.mesh());
    const glm::dvec3 size = bounds.upper - bounds.lower;
    const double longest = std::max({size.x, size.y, size.z}) / surface.cell_size();
    // A front of the automaton advances about a ninth of a cell a step (see CorrosionForces).
    const auto steps =
        static_cast<std::uint64_t>(std::clamp(std::ceil(9.0 * years * spread * longest), 1.0, 20000.0));
    const double step_years = years / static_cast<double>(steps);

    SimulationSetup growth{surface, setup.seed};
    Field<float> attack(surface.slot_count(), 0.0f), chance(surface.slot_count(), 0.0f);
    for_owned(surface, [&](std::uint32_t slot) {
      const double bare = static_cast<double>(open[slot]);
      attack[slot] = static_cast<float>(creep + (1.0 - creep) * bare);
      chance[slot] = static_cast<float>(bare * OperatorSetup::at(seeding, slot));
    });
    growth.masks = {{"attack", std::move(attack)}, {"seeding", std::move(chance)}};
    each_owned(surface, [&](std::uint32_t slot) {
      if (metal.corroded[slot] >= 0.0f) growth.seeds.push_back({slot});
    });
    CorrosionParameters parameters;
    parameters.new_seeds = std::min(0.5, spots * step_years / static_cast<double>(surface.owned_count()));
    parameters.most_seeds = 4'000'000'000u;
    parameters.thickness.k1 = 0.0;  // metal is taken by the material's law, below
    if (growth.seeds.empty() && parameters.new_seeds <= 0.0) {
      const Field<float> never(surface.slot_count(), -1.0f);
      for (std::size_t k = 0; k < setup.moments.size(); ++k) show(metal, setup, k, never);
      return never;
    }
    CorrosionGrowth run(growth, parameters);
    const auto times = [&] {
      const Field<std::int32_t> ages = run.ages();
      Field<float> time(surface.slot_count(), -1.0f);
      for_owned(surface, [&](std::uint32_t slot) {
        if (ages[slot] >= 0)
          time[slot] = static_cast<float>(effective(wet, open, slot, ages[slot] * step_years));
      });
      return time;
    };
    std::uint64_t done = 0;
    std::size_t moment = 0;
    while (done < steps) {
      run.step();
      ++done;
      // A moment between two steps is that of the second.
      const auto due = [&] {
        return moment < setup.moments.size() &&
               setup.moments[moment] * static_cast<double>(steps) <= static_cast<double>(done);
      };
      if (due()) {
        const Field<float> now = times();
        for (; due(); ++moment) show(metal, setup, moment, now);
      }
      if (!setup.go_on(static_cast<double>(done) / static_cast<double>(steps))) {
        report.complete = false;
        report.years = static_cast<double>(done) * step_years;
        break;
      }
    }
    report.numbers = {{"spots", static_cast<double>(run.seeds_placed())}};
    return times();
  }
};

}  // namespace

void add_age(OperatorCatalogue& catalogue) {
  catalogue.add<Age>();
}

}  // namespace verdigris::weathering
