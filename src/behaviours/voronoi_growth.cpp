#include "verdigris/behaviours/voronoi_growth.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"

namespace verdigris {

namespace {

void check_seeds(const SimulationSetup& setup) {
  if (setup.seeds.empty()) throw InputError("seeds", "there are none", "give at least one seed");
  if (setup.seeds.size() > 0x7FFFFFFFu) throw InputError("seeds", "more than 2^31 - 1", "give fewer seeds");
  std::unordered_map<std::uint32_t, std::size_t> at;
  double fastest = setup.seeds.front().weight, slowest = fastest;
  for (std::size_t k = 0; k < setup.seeds.size(); ++k) {
    const Seed& seed = setup.seeds[k];
    if (!(seed.weight >= std::numeric_limits<double>::min()) || !std::isfinite(seed.weight))
      throw InputError("seeds", fmt::format("seed {} has weight {}", k, seed.weight),
                       "give weights greater than 0");
    fastest = std::max(fastest, seed.weight);
    slowest = std::min(slowest, seed.weight);
    const auto [there, fresh] = at.emplace(seed.slot, k);
    if (!fresh)
      throw InputError("seeds", fmt::format("seeds {} and {} lie in one cell", there->second, k),
                       "move one of them, or use smaller cells");
    if (!setup.barrier.empty() && setup.barrier[seed.slot] != 0)
      throw InputError("seeds", fmt::format("seed {} lies on a barrier", k), "move the seed, or the barrier");
  }
  // The slowest label moves once in fastest / slowest steps: beyond this never, in double precision.
  if (slowest < 1e-12 * fastest)
    throw InputError("seeds", fmt::format("weights from {:g} to {:g}", slowest, fastest),
                     "keep weights within a factor of 1e12; runs take that many steps");
}

}  // namespace

template <typename Word>
FrontStepper<VoronoiRule<Word>> VoronoiGrowth::start(const SimulationSetup& setup,
                                                     const VoronoiParameters& parameters) const {
  using Rule = VoronoiRule<Word>;
  Rule rule;
  rule.label_bits = Rule::bits_for(setup.seeds.size());
  rule.corner_threshold = threshold(parameters.corner);
  double fastest = 0.0;
  bool equal = true;
  for (const Seed& seed : setup.seeds) {
    fastest = std::max(fastest, seed.weight);
    equal = equal && seed.weight == setup.seeds.front().weight;
  }
  if (!equal)
    for (const Seed& seed : setup.seeds) rule.speed.push_back(seed.weight / fastest);

  Field<Word> state = large_vector(setup.surface.slot_count(), Word{Rule::empty});
  if (!setup.barrier.empty()) {
    for (const Row& row : setup.surface.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        if (setup.barrier[slot] != 0) state[slot] = Rule::blocked;
  }
  std::vector<std::uint32_t> sources;
  for (std::size_t k = 0; k < setup.seeds.size(); ++k) {
    state[setup.seeds[k].slot] = rule.word(0, k);
    sources.push_back(setup.seeds[k].slot);
  }
  return FrontStepper<Rule>(setup.surface, std::move(rule), std::move(state), setup.seed, sources);
}

VoronoiGrowth::VoronoiGrowth(const SimulationSetup& setup, const VoronoiParameters& parameters)
    : surface_(setup.surface), seed_(setup.seed), seed_count_(setup.seeds.size()) {
  check_seeds(setup);
  // Labels of more than 20 bits would leave fewer than 4094 steps.
  if (setup.seeds.size() <= (std::size_t{1} << 20))
    stepper_.emplace<Narrow>(start<std::uint32_t>(setup, parameters));
  else
    stepper_.emplace<Wide>(start<std::uint64_t>(setup, parameters));
}

namespace {

VoronoiRule<std::uint64_t> wide_rule(const VoronoiRule<std::uint32_t>& narrow) {
  VoronoiRule<std::uint64_t> rule;
  rule.label_bits = narrow.label_bits;
  rule.corner_threshold = narrow.corner_threshold;
  rule.speed = narrow.speed;
  return rule;
}

}  // namespace

void VoronoiGrowth::widen() {
  const Narrow& narrow = std::get<Narrow>(stepper_);
  auto rule = wide_rule(narrow.behaviour());
  Field<std::uint64_t> state(narrow.state().size());
  std::transform(narrow.state().begin(), narrow.state().end(), state.begin(), [&](std::uint32_t w) {
    using N = VoronoiRule<std::uint32_t>;
    using W = VoronoiRule<std::uint64_t>;
    return w == N::empty ? W::empty : w == N::blocked ? W::blocked : std::uint64_t{w};
  });
  const Restart restart = narrow.restart();
  stepper_.emplace<Wide>(surface_, std::move(rule), std::move(state), seed_, restart);
}

StepReport VoronoiGrowth::step() {
  if (steps() >= 0x7FFFFFFEu)
    throw InputError("steps", "more than 2^31: arrival steps are 32-bit numbers",
                     "use --steps, or weights nearer to each other");
  if (auto* narrow = std::get_if<Narrow>(&stepper_)) {
    if (narrow->steps() < narrow->behaviour().last_step()) return narrow->step();
    widen();
  }
  return std::get<Wide>(stepper_).step();
}

namespace {
template <typename Steppers, typename Visit>
auto visit_stepper(const Steppers& stepper, Visit&& visit) {
  return stepper.index() == 1 ? visit(std::get<1>(stepper)) : visit(std::get<2>(stepper));
}
}  // namespace

bool VoronoiGrowth::finished() const {
  return visit_stepper(stepper_, [](const auto& s) { return s.finished(); });
}

std::uint64_t VoronoiGrowth::steps() const {
  return visit_stepper(stepper_, [](const auto& s) { return s.steps(); });
}

std::size_t VoronoiGrowth::bytes() const {
  return visit_stepper(stepper_, [](const auto& s) { return s.bytes(); });
}

std::vector<FieldInfo> VoronoiGrowth::fields() const {
  return {{"label", "1", "index of the seed whose region the cell is in; -1: none", FieldKind::label},
          {"arrival", "steps", "step in which growth arrived; -1: never", FieldKind::arrival}};
}

namespace {
template <typename Steppers, typename Of>
Field<std::int32_t> each_slot(const Steppers& stepper, Of&& of) {
  return visit_stepper(stepper, [&](const auto& s) {
    const auto& state = s.state();
    const auto& rule = s.behaviour();
    Field<std::int32_t> values(state.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, state.size(), std::size_t{1} << 16),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t slot = range.begin(); slot < range.end(); ++slot)
                          values[slot] = of(rule, state[slot]);
                      });
    return values;
  });
}
}  // namespace

Field<std::int32_t> VoronoiGrowth::labels() const {
  return each_slot(stepper_, [](const auto& rule, auto word) { return rule.label_of(word); });
}

Field<std::int32_t> VoronoiGrowth::arrivals() const {
  return each_slot(
      stepper_, [](const auto& rule, auto word) { return static_cast<std::int32_t>(rule.arrival_of(word)); });
}

Field<std::int32_t> VoronoiGrowth::field(std::string_view name) const {
  if (name == "label") return labels();
  if (name == "arrival") return arrivals();
  throw std::out_of_range(std::string(name));
}

SavedState VoronoiGrowth::save() const {
  return visit_stepper(stepper_, [&](const auto& s) { return save_stepper(surface_, s); });
}

template <typename Word>
void VoronoiGrowth::restart(const SavedState& saved, const VoronoiRule<Word>& rule) {
  using Stepper = FrontStepper<VoronoiRule<Word>>;
  const Restart restart = restart_of(surface_, saved);
  Field<Word> state = restore_cells(surface_, saved, rule.outside());
  for (const Word word : state)
    if (rule.filled(word) && (static_cast<std::size_t>(rule.label_of(word)) >= seed_count_ ||
                              static_cast<std::uint64_t>(rule.arrival_of(word)) > restart.step))
      throw InputError("saved state", "it holds labels or steps that this growth cannot have reached",
                       "start again");
  stepper_.emplace<Stepper>(surface_, VoronoiRule<Word>(rule), std::move(state), seed_, restart);
}

void VoronoiGrowth::restore(const SavedState& saved) {
  const bool narrow = !saved.arrays.empty() && saved.arrays[0].element_size == sizeof(std::uint32_t);
  if (const auto* now = std::get_if<Narrow>(&stepper_))
    narrow ? restart(saved, now->behaviour()) : restart(saved, wide_rule(now->behaviour()));
  else
    restart(saved, std::get<Wide>(stepper_).behaviour());
}

std::vector<Seed> random_seeds(const Surface& surface, std::size_t count, std::uint64_t seed,
                               const Field<std::uint8_t>& barrier) {
  // Every owned cell has the same area: a cell at random is a place at random.
  std::vector<std::uint64_t> before;  // [row] owned cells in the rows before it
  std::uint64_t cells = 0, free = 0;
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row) {
    const SlotRun run = surface.owned(row);
    before.push_back(cells);
    cells += run.end - run.begin;
    free += barrier.empty() ? run.end - run.begin
                            : static_cast<std::uint64_t>(
                                  std::count(barrier.begin() + run.begin, barrier.begin() + run.end, 0));
  }
  if (count > free)
    throw InputError(
        "seeds",
        fmt::format("{} seeds for {} cells{}", count, free, barrier.empty() ? "" : " outside the barrier"),
        "give fewer seeds, or use smaller cells");

  constexpr std::uint32_t placing = 0x53454544;
  std::vector<Seed> seeds;
  std::vector<bool> taken(surface.slot_count(), false);
  const auto take = [&](std::uint64_t cell) {
    const auto row =
        static_cast<std::size_t>(std::upper_bound(before.begin(), before.end(), cell) - before.begin() - 1);
    const auto slot = static_cast<std::uint32_t>(surface.owned(static_cast<std::uint32_t>(row)).begin +
                                                 (cell - before[row]));
    if (taken[slot] || (!barrier.empty() && barrier[slot] != 0)) return;
    taken[slot] = true;
    seeds.push_back({slot, 1.0});
  };
  std::uint64_t draw = 0;
  const auto next_below = [&](std::uint64_t limit) {
    const auto word = CellRandom(seed, draw >> 32, static_cast<std::uint32_t>(draw)).words(placing);
    ++draw;
    // A 64-bit fraction of `limit`, which is below 2^32.
    return (word[0] * limit + (word[1] * limit >> 32)) >> 32;
  };
  if (count > free / 2) {
    // Nearly every cell: draw from a list of those that are left.
    std::vector<std::uint32_t> left;
    for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
      for (std::uint32_t slot = surface.owned(row).begin; slot < surface.owned(row).end; ++slot)
        if (barrier.empty() || barrier[slot] == 0) left.push_back(slot);
    for (std::size_t k = 0; k < count; ++k) {
      std::swap(left[k], left[k + next_below(left.size() - k)]);
      seeds.push_back({left[k], 1.0});
    }
    return seeds;
  }
  while (seeds.size() < count) take(next_below(cells));
  return seeds;
}

BehaviourEntry voronoi_entry() {
  return {"voronoi", "regions grow from seeds until they meet (Gobron & Chiba 1999)", true,
          describe_parameters<VoronoiParameters>(),
          [](const SimulationSetup& setup, const ParameterValues& values) -> std::unique_ptr<AnySimulation> {
            return std::make_unique<VoronoiGrowth>(setup,
                                                   with_parameters<VoronoiParameters>("voronoi", values));
          }};
}

}  // namespace verdigris
