#pragma once
// Corrosion as a simulation: seeds and masks in; age, metal and oxide of each cell out.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/behaviours/corrosion.hpp"
#include "verdigris/behaviours/corrosion_thickness.hpp"

namespace verdigris {

/// Parameters of corrosion. Forces and defences are pure numbers that are only compared with each other.
struct CorrosionParameters {
  double strong = 0.3;
  std::string strong_by = "chance";
  double new_seeds = 3e-6;
  std::uint64_t most_seeds = 64;
  CorrosionForces forces;
  LinearThickness thickness;

  template <typename V>
  void parameters(V&& v) {
    v("strong", strong, 0.0, 1.0, "1", "share of strong cells");
    v("strong_by", strong_by, {"chance", "highest"},
      "what the mask 'strong' says: each cell's chance to be strong, or an order whose highest share is");
    v("new_seeds", new_seeds, 0.0, 1.0, "1/step",
      "share of weak sound cells that start to corrode each step");
    v("most_seeds", most_seeds, 0.0, 4e9, "1", "new seeds in all");
    v("attack", forces.attack, 0.0, 1e6, "1", "greatest force of an attack");
    v("luck", forces.luck, 0.0, 1.0, "1", "random share of the force; 0: age alone decides");
    v("attack_age", forces.attack_age, 1.0, 1e6, "steps", "age at which a cell attacks with full force");
    v("reach_age", forces.reach_age, 1.0, 1e6, "steps",
      "age at which it attacks all sound neighbours, seven at most");
    v("defence", forces.defence, 0.0, 1e6, "1", "defence of a weak cell");
    v("strong_defence", forces.strong_defence, 0.0, 1e6, "1", "defence of a strong cell");
    v("support", forces.support, 0.0, 1e6, "1", "defence that each strong sound neighbour adds");
    v("metal", thickness.metal, 0.0, 1e9, "um", "thickness of the metal");
    v("k1", thickness.k1, 0.0, 1e6, "um/step", "metal lost by a corroded cell");
    v("k2", thickness.k2, 0.0, 1e6, "um/step", "oxide gained by a corroded cell");
    v("k3", thickness.k3, 0.0, 1e9, "um", "greatest thickness of the oxide");
  }
};

/// Spots of corrosion growing from seeds: those given, and new ones that appear by chance. Steps visit only
/// the rims of the spots; thickness is computed when asked for.
///
/// Masks, all 0 to 1: "strong" (see strong_by), "seeding" (relative chance of a new seed), "attack" (share of
/// a force that arrives in the cell), "rate" (multiplies k1 and k2).
class CorrosionGrowth final : public AnySimulation {
 public:
  /// Throws InputError when nothing can ever corrode for want of seeds, a seed lies on a barrier or twice in
  /// one cell, a mask is not of this surface, or links are projected.
  CorrosionGrowth(const SimulationSetup& setup, const CorrosionParameters& parameters);
  CorrosionGrowth(const CorrosionGrowth&) = delete;

  /// `changed` counts the cells that became corroded.
  StepReport step() override;
  bool finished() const override;  ///< no cell can change, and no new seed can come
  std::uint64_t steps() const override { return stepper_->steps(); }
  std::size_t bytes() const override;
  std::vector<FieldInfo> fields() const override;
  Field<std::int32_t> field(std::string_view name) const override;
  Field<float> real_field(std::string_view name) const override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;

  const Surface& surface() const { return surface_; }
  const CorrosionParameters& parameters() const { return parameters_; }
  const Field<CorrosionRule::State>& words() const { return stepper_->state(); }
  const CorrosionRule& rule() const { return stepper_->behaviour(); }

  /// Steps since a cell corroded, for every slot; -1: sound. Cells without metal keep ageing.
  Field<std::int32_t> ages() const;
  /// The mask "rate" for every slot; empty when there is none.
  const Field<std::uint8_t>& rates() const { return rate_; }

  std::uint64_t seeds_placed() const { return placed_; }  ///< new ones, beside those given
  /// [step] owned cells that became corroded in it; index 0 are the given seeds.
  const std::vector<std::uint64_t>& births() const { return births_; }
  /// Calls visit(age in steps, rate 0..1, cells) for the owned cells that have ever corroded, those of one
  /// age and rate together: its cost grows with the steps made, not with the cells. As it stood after step
  /// `at`, at most the last.
  void visit_cohorts(std::uint64_t at,
                     const std::function<void(std::uint64_t, double, std::uint64_t)>& visit) const;
  void visit_cohorts(const std::function<void(std::uint64_t, double, std::uint64_t)>& visit) const {
    visit_cohorts(steps(), visit);
  }

 private:
  using Stepper = FrontStepper<CorrosionRule>;
  void sow();
  void count_birth(std::uint32_t slot, CorrosionRule::State word);
  void count_all();
  bool may_seed(std::uint32_t slot, CorrosionRule::State word) const;

  const Surface& surface_;
  std::uint64_t seed_;
  CorrosionParameters parameters_;
  Field<std::uint8_t> seeding_, exposure_, rate_;  // masks, 255: 1; empty: 1 everywhere
  std::unique_ptr<Stepper> stepper_;
  std::uint64_t calm_ = 0;  // steps since anything but directions of attack changed
  std::uint64_t placed_ = 0;
  std::uint64_t seedable_ = 0;  // sound cells in which a new seed may come
  std::vector<std::uint64_t> births_;
  std::vector<std::vector<std::uint32_t>> births_at_rate_;  // [rate][step]; empty without that mask
};

/// The catalogue entry of corrosion.
BehaviourEntry corrosion_entry();

}  // namespace verdigris
