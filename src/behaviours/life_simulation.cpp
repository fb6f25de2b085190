#include "verdigris/behaviours/life_simulation.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/behaviours/larger_than_life.hpp"
#include "verdigris/behaviours/packed_life.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t soup_purpose = 0x4C494601;

std::vector<FieldInfo> alive_only() {
  return {{"alive", "1", "1 where a cell lives, 0 where not"}};
}

Field<std::uint8_t> first_generation(const SimulationSetup& setup, double density) {
  Field<std::uint8_t> alive = large_vector(setup.surface.slot_count(), std::uint8_t{0});
  const auto rows = setup.surface.rows();
  const Field<float>* mask = setup.mask("alive");
  const std::uint64_t limit = threshold(density);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, rows.size(), 64), [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t r = range.begin(); r < range.end(); ++r)
          for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
            alive[slot] = mask != nullptr ? (*mask)[slot] >= 0.5f
                                          : CellRandom(setup.seed, 0, slot).words(soup_purpose)[0] < limit;
      });
  for (const Seed& seed : setup.seeds) alive[seed.slot] = 1;
  return alive;
}

// What both kinds share.
class LifeSimulation : public AnySimulation {
 public:
  explicit LifeSimulation(const Surface& surface) : surface_(surface) {}
  bool finished() const override { return still_; }
  std::vector<FieldInfo> fields() const override { return alive_only(); }
  StepReport step() override {
    const std::uint64_t changed = advance();
    still_ = changed == 0;
    return {steps(), changed, surface_.owned_count()};
  }

 protected:
  virtual std::uint64_t advance() = 0;
  StateArray save_still() const {
    const std::uint8_t still = still_;
    return save_numbers("still", std::span(&still, 1));
  }
  void restore_still(const SavedState& saved) {
    still_ = restore_numbers<std::uint8_t>(saved, "still") == std::vector<std::uint8_t>{1};
  }
  const Surface& surface_;
  bool still_ = false;
};

class PackedSimulation final : public LifeSimulation {
 public:
  PackedSimulation(const SimulationSetup& setup, const LifeRule& rule, double density)
      : LifeSimulation(setup.surface), cells_(setup.surface), life_(cells_, rule) {
    const Field<std::uint8_t> alive = first_generation(setup, density);
    for_owned([&](std::uint32_t slot, std::uint32_t bit) {
      if (alive[slot] != 0) life_.set(bit, true);
    });
  }
  std::uint64_t steps() const override { return life_.steps(); }
  std::size_t bytes() const override { return cells_.bytes() + life_.bytes(); }
  Field<std::int32_t> field(std::string_view name) const override {
    if (name != "alive") throw std::out_of_range(std::string(name));
    Field<std::int32_t> values(surface_.slot_count(), 0);
    for_owned([&](std::uint32_t slot, std::uint32_t bit) { values[slot] = life_.alive(bit); });
    copy_to_ghosts(surface_, values);
    return values;
  }
  SavedState save() const override {
    return {life_.steps(), {save_numbers("alive", std::span(life_.state())), save_still()}};
  }
  void restore(const SavedState& saved) override {
    life_.restore(restore_numbers<std::uint64_t>(saved, "alive"), saved.step);
    restore_still(saved);
  }

 private:
  std::uint64_t advance() override { return life_.step(); }
  // In parallel by rows: a word holds cells of one row only. Its first cell is looked up, the others follow.
  template <typename Visit>
  void for_owned(Visit&& visit) const {
    const auto rows = surface_.rows();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rows.size(), 64),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t r = range.begin(); r < range.end(); ++r) {
                          std::uint32_t slot = rows[r].run_begin;
                          while (slot < rows[r].run_end) {
                            std::uint32_t bit = cells_.bit_of(surface_, slot);
                            do visit(slot++, bit++);
                            while (slot < rows[r].run_end && (bit & 63) != 0);
                          }
                        }
                      });
  }

  PackedSurface cells_;
  PackedLife life_;
};

class RangeSimulation final : public LifeSimulation {
 public:
  RangeSimulation(const SimulationSetup& setup, const RangeRule& rule, double density)
      : LifeSimulation(setup.surface),
        rule_(rule),
        halo_(setup.surface, rule.range),
        life_(halo_, rule, first_generation(setup, density)) {}
  std::uint64_t steps() const override { return life_.steps(); }
  std::size_t bytes() const override { return halo_.bytes() + life_.bytes(); }
  Field<std::int32_t> field(std::string_view name) const override {
    if (name != "alive") throw std::out_of_range(std::string(name));
    Field<std::int32_t> values(life_.alive().begin(), life_.alive().end());
    copy_to_ghosts(surface_, values);
    return values;
  }
  SavedState save() const override {
    return {life_.steps(), {save_cells(surface_, life_.alive()), save_still()}};
  }
  void restore(const SavedState& saved) override {
    auto alive = restore_cells<std::uint8_t>(surface_, saved, 0);
    if (std::any_of(alive.begin(), alive.end(), [](std::uint8_t a) { return a > 1; }))
      throw InputError("cells", "a state is neither 0 nor 1", "start again without this checkpoint");
    life_ = LargerThanLife(halo_, rule_, std::move(alive), saved.step);
    restore_still(saved);
  }

 private:
  std::uint64_t advance() override { return life_.step(); }

  RangeRule rule_;
  Halo halo_;
  LargerThanLife life_;
};

bool has_range(std::string_view rule) {
  return rule.size() > 1 && (rule[0] == 'R' || rule[0] == 'r') && rule[1] >= '0' && rule[1] <= '9';
}

}  // namespace

std::unique_ptr<AnySimulation> make_life(const SimulationSetup& setup, const LifeParameters& parameters) {
  if (setup.surface.link_kind() != LinkKind::unfolded)
    throw InputError("links", "life counts neighbours, and projected pairs have none", "use unfolded links");
  if (!setup.barrier.empty())
    throw InputError("barrier", "life takes no barrier mask",
                     "bar edges by their angle, or leave the mask out");
  if (has_range(parameters.rule))
    return std::make_unique<RangeSimulation>(setup, parse_range_rule(parameters.rule), parameters.density);
  return std::make_unique<PackedSimulation>(setup, parse_life_rule(parameters.rule), parameters.density);
}

BehaviourEntry life_entry() {
  BehaviourEntry entry;
  entry.name = "life";
  entry.summary = "two states, birth and survival by counting live neighbours: Life and its relatives";
  entry.parameters = describe_parameters<LifeParameters>();
  entry.create = [](const SimulationSetup& setup, const ParameterValues& values) {
    return make_life(setup, with_parameters<LifeParameters>("life", values));
  };
  entry.masks = {"alive"};
  entry.on_projected = false;
  entry.default_steps = 100;
  return entry;
}

}  // namespace verdigris
