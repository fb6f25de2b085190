#pragma once
// A behaviour running on a surface: typed for those who know the behaviour, and by name for programs.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verdigris/automaton/front.hpp"
#include "verdigris/automaton/sweep.hpp"

namespace verdigris {

/// The stepping that suits a behaviour: from its front where it can, else by full sweeps.
template <Behaviour B>
struct StepperOf {
  using type = SweepStepper<B>;
};
template <FrontBehaviour B>
struct StepperOf<B> {
  using type = FrontStepper<B>;
};
template <Behaviour B>
using Simulation = typename StepperOf<B>::type;

/// A field that a running behaviour offers for pictures and files.
struct FieldInfo {
  std::string name;
  std::string unit;  ///< "1" for a pure number
  std::string help;
};

/// A simulation whose behaviour is known by name only: one virtual call a step, none a cell.
class AnySimulation {
 public:
  virtual ~AnySimulation() = default;
  virtual StepReport step() = 0;
  virtual bool finished() const = 0;         ///< nothing can change any more
  virtual std::uint64_t steps() const = 0;
  virtual std::size_t bytes() const = 0;     ///< memory of states and lists
  virtual std::vector<FieldInfo> fields() const = 0;  ///< the first is what pictures show
  /// The values of a field for every slot. Throws std::out_of_range for a name not in fields().
  virtual Field<std::int32_t> field(std::string_view name) const = 0;
};

/// AnySimulation of a self-describing behaviour (see Catalogue::add), its cells started by `initial`.
template <typename B>
class RuleSimulation final : public AnySimulation {
 public:
  RuleSimulation(const Surface& surface, B behaviour, std::uint64_t seed)
      : stepper_(surface, behaviour, start(surface, behaviour, seed), seed) {}

  StepReport step() override { return last_ = stepper_.step(); }
  bool finished() const override {
    if constexpr (FrontBehaviour<B>) return stepper_.finished();
    return last_.step != 0 && last_.changed == 0;
  }
  std::uint64_t steps() const override { return stepper_.steps(); }
  std::size_t bytes() const override { return 2 * stepper_.state().size() * sizeof(typename B::State); }
  std::vector<FieldInfo> fields() const override { return {{"state", "1", "state of the cell"}}; }
  Field<std::int32_t> field(std::string_view name) const override {
    if (name != "state") throw std::out_of_range(std::string(name));
    Field<std::int32_t> values(stepper_.state().size());
    for (std::size_t slot = 0; slot < values.size(); ++slot)
      values[slot] = static_cast<std::int32_t>(stepper_.state()[slot]);
    return values;
  }

 private:
  static Field<typename B::State> start(const Surface& surface, const B& behaviour, std::uint64_t seed) {
    Field<typename B::State> state(surface.slot_count(), behaviour.outside());
    for (const Row& row : surface.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        state[slot] = behaviour.initial(CellRandom(seed, 0, slot));
    return state;
  }

  Simulation<B> stepper_;
  StepReport last_;
};

}  // namespace verdigris
