#include "verdigris/weathering/timeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "verdigris/automaton/random.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/exposure/mask_expression.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t step_purpose = 0x54494d01;

// What a step gives to its operator.
struct Given {
  ParameterValues parameters;
  std::vector<std::pair<std::string, std::string>> masks;  // name, expression
};

std::string where_of(const TimelineStep& step) {
  return step.where.empty() ? step.op : fmt::format("{}: {}", step.where, step.op);
}

Given given_by(const OperatorEntry& entry, const TimelineStep& step) {
  Given given;
  for (const auto& [name, value] : step.values) {
    if (std::find(entry.masks.begin(), entry.masks.end(), name) == entry.masks.end()) {
      given.parameters.emplace_back(name, value);
      continue;
    }
    const auto* text = std::get_if<std::string>(&value);
    given.masks.emplace_back(name, text != nullptr ? *text : fmt::format("{}", std::get<double>(value)));
  }
  return given;
}

const OperatorEntry& entry_of(const OperatorCatalogue& operators, const TimelineStep& step) {
  try {
    return operators.find(step.op);
  } catch (const InputError& error) {
    throw InputError(step.where.empty() ? error.where() : step.where, error.problem(), error.remedy());
  }
}

// Shows the moments of a timeline as its operations come to them.
class Moments {
 public:
  explicit Moments(const TimelineListener& listener)
      : listener_(listener), count_(listener.at ? listener.moments.size() : 0) {}

  // Those up to a place whose state is at hand.
  void until(double place, const CoatedMetal& metal) {
    for (; next_ < count_ && listener_.moments[next_] <= place; ++next_) listener_.at(next_, metal);
  }
  // Leaves those inside operation `step` to it.
  void give(OperatorSetup& setup, std::size_t step) {
    const auto begin = static_cast<double>(step);
    for (std::size_t k = next_; k < count_ && listener_.moments[k] < begin + 1.0; ++k)
      setup.moments.push_back(listener_.moments[k] - begin);
    setup.show = [this, first = next_](std::size_t moment, const CoatedMetal& metal) {
      showing_ = true;
      listener_.at(first + moment, metal);
      showing_ = false;
    };
  }
  // Stays true when the listener throws.
  bool showing() const { return showing_; }
  void given(const OperatorSetup& setup) { next_ += setup.moments.size(); }

 private:
  const TimelineListener& listener_;
  std::size_t count_, next_ = 0;
  bool showing_ = false;
};

// What is said to be wrong, with the place in the scene before it, unless it is said by the listener.
template <typename Work>
void at_its_place(const TimelineStep& step, const Work& work, const Moments* moments = nullptr) {
  try {
    work();
  } catch (const InputError& error) {
    if (step.where.empty() || (moments != nullptr && moments->showing())) throw;
    throw InputError(fmt::format("{}: {}", step.where, error.where()), error.problem(), error.remedy());
  }
}

}  // namespace

std::vector<double> timeline_years(const OperatorCatalogue& operators, std::span<const TimelineStep> steps) {
  std::vector<double> years;
  for (const TimelineStep& step : steps) {
    const OperatorEntry& entry = entry_of(operators, step);
    years.push_back(entry.years ? entry.years(given_by(entry, step).parameters) : 0.0);
  }
  return years;
}

void check_timeline(const OperatorCatalogue& operators, std::span<const TimelineStep> steps,
                    std::span<const std::string> mask_names) {
  for (const TimelineStep& step : steps) {
    const OperatorEntry& entry = entry_of(operators, step);
    const Given given = given_by(entry, step);
    check_parameters(where_of(step), entry.parameters, given.parameters);
    if (entry.check) at_its_place(step, [&] { entry.check(given.parameters); });
    for (const auto& [name, expression] : given.masks)
      MaskExpression(expression, mask_names, fmt::format("{}.{}", where_of(step), name));
  }
}

std::vector<TimelineRecord> run_timeline(const OperatorCatalogue& operators, const Surface& surface,
                                         CoatedMetal& metal, std::span<const TimelineStep> steps,
                                         MaskBook& masks, std::uint64_t seed,
                                         const TimelineListener& listener) {
  std::vector<TimelineRecord> records;
  double years = 0.0;
  Moments moments(listener);
  const std::vector<double> durations = timeline_years(operators, steps);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    moments.until(static_cast<double>(k), metal);
    const auto begin = std::chrono::steady_clock::now();
    const OperatorEntry& entry = entry_of(operators, steps[k]);
    const Given given = given_by(entry, steps[k]);
    OperatorSetup setup{surface};
    const auto words = CellRandom(seed, 0, static_cast<std::uint32_t>(k)).words(step_purpose);
    setup.seed = std::uint64_t{words[0]} << 32 | words[1];
    setup.up = masks.sources().up();
    setup.exposures = &masks.sources().exposures();
    for (const auto& [name, expression] : given.masks)
      setup.masks.push_back(
          {name, masks.evaluate(expression, fmt::format("{}.{}", where_of(steps[k]), name), metal)});
    if (listener.progress) setup.progress = [&](double share) { return listener.progress(k, share); };
    if (durations[k] > 0.0) moments.give(setup, k);
    TimelineRecord record{steps[k].op, 0.0, {}, {}, 0.0};
    at_its_place(
        steps[k], [&] { record.report = entry.apply(metal, setup, given.parameters); }, &moments);
    moments.given(setup);
    show_ghosts(surface, metal);
    years += record.report.years;
    record.years = years;
    record.numbers = measure(surface, metal);
    record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    records.push_back(std::move(record));
    if (listener.after) listener.after(k, metal, records.back());
    if (!records.back().report.complete) break;
    if (listener.progress && !listener.progress(k, 1.0)) break;
  }
  if (records.size() == steps.size() && (records.empty() || records.back().report.complete))
    moments.until(static_cast<double>(steps.size()), metal);
  return records;
}

}  // namespace verdigris
