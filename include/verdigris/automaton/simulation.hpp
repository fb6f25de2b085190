#pragma once
// A behaviour running on a surface: typed for those who know the behaviour, and by name for programs.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/automaton/active.hpp"
#include "verdigris/automaton/front.hpp"
#include "verdigris/automaton/saved_state.hpp"
#include "verdigris/automaton/sweep.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"

namespace verdigris {

/// The stepping that suits what a behaviour declares: from its front, on active rows, else by full sweeps.
template <Behaviour B>
struct StepperOf {
  using type = SweepStepper<B>;
};
template <FrontBehaviour B>
struct StepperOf<B> {
  using type = FrontStepper<B>;
};
template <RestingBehaviour B>
requires(!FrontBehaviour<B>) struct StepperOf<B> {
  using type = ActiveStepper<B>;
};
template <Behaviour B>
using Simulation = typename StepperOf<B>::type;

/// What the numbers of a field say.
enum class FieldKind : std::uint8_t {
  quantity,  ///< how much
  label,     ///< which region; -1: none
  arrival,   ///< the step in which a cell was reached; -1: never
};

/// A field that a running behaviour offers for pictures and files.
struct FieldInfo {
  std::string name;
  std::string unit;  ///< "1" for a pure number
  std::string help;
  FieldKind kind = FieldKind::quantity;
  bool real = false;  ///< it is real_field() that gives it, not field()
};

/// A simulation whose behaviour is known by name only: one virtual call a step, none a cell.
class AnySimulation {
 public:
  virtual ~AnySimulation() = default;
  virtual StepReport step() = 0;
  virtual bool finished() const = 0;  ///< nothing can change any more
  virtual std::uint64_t steps() const = 0;
  virtual std::size_t bytes() const = 0;              ///< memory of states and lists
  virtual std::vector<FieldInfo> fields() const = 0;  ///< the first is what pictures show
  /// The values of a field of whole numbers, or of a real one, for every slot. Both throw std::out_of_range
  /// for a name that is not such a one in fields().
  virtual Field<std::int32_t> field(std::string_view name) const = 0;
  virtual Field<float> real_field(std::string_view name) const { throw std::out_of_range(std::string(name)); }

  /// Where it stands: `restore` of another one, made with the same setup and parameters, goes on from there
  /// with the same bits. Both throw InputError for a behaviour that does not support it, `restore` for a
  /// state that is not of such a one.
  virtual SavedState save() const { throw_no_restart(); }
  virtual void restore(const SavedState&) { throw_no_restart(); }

 private:
  [[noreturn]] static void throw_no_restart() {
    throw InputError("behaviour", "its state cannot be saved", "run it without checkpoints");
  }
};

/// AnySimulation of a self-describing behaviour (see Catalogue::add), its cells started by `initial`.
template <typename B>
class RuleSimulation final : public AnySimulation {
 public:
  using State = typename B::State;

  RuleSimulation(const Surface& surface, B behaviour, std::uint64_t seed)
      : surface_(surface),
        seed_(seed),
        stepper_(std::in_place, surface, behaviour, start(surface, behaviour, seed), seed) {}

  StepReport step() override {
    const StepReport report = stepper_->step();
    ended_ = RestingBehaviour<B> && report.changed == 0;
    return report;
  }
  bool finished() const override {
    if constexpr (FrontBehaviour<B>) return ended_ || stepper_->finished();
    return ended_;
  }
  std::uint64_t steps() const override { return stepper_->steps(); }
  std::size_t bytes() const override { return stepper_->bytes(); }
  std::vector<FieldInfo> fields() const override { return {{"state", "1", "state of the cell"}}; }
  Field<std::int32_t> field(std::string_view name) const override {
    if (name != "state") throw std::out_of_range(std::string(name));
    const Field<State>& state = stepper_->state();
    Field<std::int32_t> values(state.size());
    for (std::size_t slot = 0; slot < values.size(); ++slot)
      values[slot] = static_cast<std::int32_t>(state[slot]);
    return values;
  }

  SavedState save() const override {
    SavedState saved = save_stepper(surface_, *stepper_);
    // After a restart a front looks at every cell once more: that there was none left has to be remembered.
    const std::uint8_t ended = finished();
    saved.arrays.push_back(save_numbers("ended", std::span(&ended, 1)));
    return saved;
  }
  void restore(const SavedState& saved) override {
    const auto ended = restore_numbers<std::uint8_t>(saved, "ended");
    Field<State> state = restore_cells(surface_, saved, stepper_->behaviour().outside());
    const Restart restart = restart_of(surface_, saved);
    stepper_.emplace(surface_, B(stepper_->behaviour()), std::move(state), seed_, restart);
    ended_ = ended == std::vector<std::uint8_t>{1};
  }

 private:
  static Field<State> start(const Surface& surface, const B& behaviour, std::uint64_t seed) {
    Field<State> state = large_vector(surface.slot_count(), State(behaviour.outside()));
    for (const Row& row : surface.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        state[slot] = behaviour.initial(CellRandom(seed, 0, slot));
    return state;
  }

  const Surface& surface_;
  std::uint64_t seed_;
  std::optional<Simulation<B>> stepper_;
  bool ended_ = false;
};

}  // namespace verdigris
