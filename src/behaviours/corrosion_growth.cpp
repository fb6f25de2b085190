#include "verdigris/behaviours/corrosion_growth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "corrosion_start.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/surface/owned_cells.hpp"

namespace verdigris {

namespace {

using Word = CorrosionRule::State;
constexpr std::uint32_t sowing_purpose = 0x434f5203;

}  // namespace

CorrosionGrowth::CorrosionGrowth(const SimulationSetup& setup, const CorrosionParameters& parameters)
    : surface_(setup.surface),
      seed_(setup.seed),
      parameters_(parameters),
      seeding_(corrosion::levels_of(setup, "seeding")),
      exposure_(corrosion::levels_of(setup, "attack")),
      rate_(corrosion::levels_of(setup, "rate")) {
  corrosion::check(setup, parameters);
  CorrosionRule rule(parameters.forces);
  rule.exposure = exposure_;
  rule.rate = rate_;
  for (std::size_t k = 0; k < rule.lifetime.size(); ++k)
    rule.lifetime[k] = parameters.thickness.lifetime(static_cast<double>(k) / 255.0);
  auto state = corrosion::first_state(setup, parameters, rule);
  stepper_ = std::make_unique<Stepper>(surface_, rule, std::move(state), seed_);
  count_all();
}

bool CorrosionGrowth::may_seed(std::uint32_t slot, Word word) const {
  return CorrosionRule::sound(word) && !CorrosionRule::strong(word) &&
         (seeding_.empty() || seeding_[slot] != 0);
}

void CorrosionGrowth::count_birth(std::uint32_t slot, Word word) {
  const std::uint64_t step = CorrosionRule::birth(word);
  if (births_.size() <= step) births_.resize(step + 1);
  ++births_[step];
  if (rate_.empty()) return;
  auto& at_rate = births_at_rate_[rate_[slot]];
  if (at_rate.size() <= step) at_rate.resize(step + 1);
  ++at_rate[step];
}

// What is known of the births stands in the words.
void CorrosionGrowth::count_all() {
  births_.assign(steps() + 1, 0);
  births_at_rate_.assign(rate_.empty() ? 0 : 256, {});
  seedable_ = 0;
  each_owned(surface_, [&](std::uint32_t slot) {
    const Word word = words()[slot];
    if (CorrosionRule::corroded(word)) count_birth(slot, word);
    seedable_ += may_seed(slot, word);
  });
}

StepReport CorrosionGrowth::step() {
  if (steps() >= CorrosionRule::last_step)
    throw InputError("steps", fmt::format("more than {}", CorrosionRule::last_step),
                     "use fewer, longer steps");
  StepReport report = stepper_->step();
  ++calm_;
  births_.resize(report.step + 1);
  stepper_->visit_changes([&](std::uint32_t slot, Word word) {
    const bool born = CorrosionRule::corroded(word) && CorrosionRule::birth(word) == report.step;
    if (born || CorrosionRule::sound(word)) calm_ = 0;
    if (!born) return;
    count_birth(slot, word);
    seedable_ -= !CorrosionRule::strong(word) && (seeding_.empty() || seeding_[slot] != 0);
  });
  sow();
  report.changed = births_[report.step];
  return report;
}

// A cell may attack for ever one that does not see it, over an edge between turned grids. So a front at which
// no sound cell is threatened is at rest, once no word but the attackers' directions has changed for two
// steps: one in which holds may fall, one in which idle cells hear of it.
bool CorrosionGrowth::finished() const {
  if (parameters_.new_seeds > 0.0 && placed_ < parameters_.most_seeds && seedable_ > 0) return false;
  if (stepper_->finished()) return true;
  if (calm_ < 2 || stepper_->any_alarm()) return false;
  return !stepper_->any_candidate([&](const Neighbourhood<Word>& n) {
    return rule().threatened(n, static_cast<std::uint32_t>(n.here - words().data()));
  });
}

// Each slot is a trial: those that succeed are found by the distances between them, which are geometric. What
// falls on a ghost, a strong or a corroded cell, or fails the mask, is no seed: so every cell that may seed
// has its chance, and the work is that of the seeds. (A cell may be drawn twice: of n p successes n p^2 / 2.)
void CorrosionGrowth::sow() {
  if (parameters_.new_seeds <= 0.0 || placed_ >= parameters_.most_seeds || seedable_ == 0) return;
  const std::uint64_t now = steps(), slots = surface_.slot_count();
  const double log_miss = std::log1p(-parameters_.new_seeds);
  double trials = 0.0;
  for (std::uint32_t k = 0; placed_ < parameters_.most_seeds && seedable_ > 0; ++k) {
    const auto word = CellRandom(seed_, now, k).words(sowing_purpose);
    trials += 1.0 + std::floor(std::log((word[0] + 0.5) / 4294967296.0) / log_miss);
    if (trials > static_cast<double>(slots)) return;
    const auto slot = static_cast<std::uint32_t>(word[1] * slots >> 32);
    if (!may_seed(slot, words()[slot]) || !surface_.is_owned(slot)) continue;
    if (!seeding_.empty() && word[2] % 255 >= seeding_[slot]) continue;
    const Word seed = CorrosionRule::corroded_word(now, words()[slot]);
    stepper_->put(slot, seed);
    count_birth(slot, seed);
    ++placed_;
    calm_ = 0;
    --seedable_;
  }
}

std::size_t CorrosionGrowth::bytes() const {
  std::size_t sum = stepper_->bytes() + seeding_.size() + exposure_.size() + rate_.size() +
                    births_.capacity() * sizeof(births_[0]);
  for (const auto& births : births_at_rate_) sum += births.capacity() * sizeof(births[0]);
  return sum;
}

void CorrosionGrowth::visit_cohorts(
    std::uint64_t at, const std::function<void(std::uint64_t, double, std::uint64_t)>& visit) const {
  const auto visit_births = [&](const auto& births, double rate) {
    for (std::size_t step = 0; step < births.size() && step <= at; ++step)
      if (births[step] != 0) visit(at - step, rate, births[step]);
  };
  if (rate_.empty()) return visit_births(births_, 1.0);
  for (std::size_t k = 0; k < births_at_rate_.size(); ++k)
    visit_births(births_at_rate_[k], static_cast<double>(k) / 255.0);
}

SavedState CorrosionGrowth::save() const {
  SavedState saved = save_stepper(surface_, *stepper_);
  saved.arrays.push_back(save_numbers("calm", std::span<const std::uint64_t>(&calm_, 1)));
  saved.arrays.push_back(save_numbers("placed", std::span<const std::uint64_t>(&placed_, 1)));
  return saved;
}

void CorrosionGrowth::restore(const SavedState& saved) {
  const Restart restart = restart_of(surface_, saved);
  const auto placed = restore_numbers<std::uint64_t>(saved, "placed");
  const auto calm = restore_numbers<std::uint64_t>(saved, "calm");
  Field<Word> state = restore_cells(surface_, saved, rule().outside());
  const bool possible = std::all_of(state.begin(), state.end(), [&](Word word) {
    return !CorrosionRule::corroded(word) || CorrosionRule::birth(word) <= restart.step;
  });
  if (placed.size() != 1 || calm.size() != 1 || placed[0] > parameters_.most_seeds || !possible)
    throw InputError("saved state", "it holds seeds or steps that this corrosion cannot have reached",
                     "start again");
  CorrosionRule at_rest(rule());
  at_rest.now = restart.step;
  stepper_ = std::make_unique<Stepper>(surface_, std::move(at_rest), std::move(state), seed_, restart);
  placed_ = placed[0];
  calm_ = calm[0];
  count_all();
}

BehaviourEntry corrosion_entry() {
  BehaviourEntry entry{
      "corrosion", "spots of corrosion spread by attack and defence between cells (Gobron & Chiba 1999)",
      false, describe_parameters<CorrosionParameters>(),
      [](const SimulationSetup& setup, const ParameterValues& values) -> std::unique_ptr<AnySimulation> {
        return std::make_unique<CorrosionGrowth>(setup,
                                                 with_parameters<CorrosionParameters>("corrosion", values));
      }};
  // Saturated long before; but a last cell that only a new seed can reach would keep it going.
  entry.default_steps = 100'000;
  entry.on_projected = false;
  entry.masks = {"strong", "seeding", "attack", "rate"};
  return entry;
}

}  // namespace verdigris
