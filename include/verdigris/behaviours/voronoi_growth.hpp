#pragma once
// Voronoi growth as a simulation: seeds in, label and arrival step of each cell out.

#include <cstdint>
#include <memory>
#include <variant>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/behaviours/voronoi.hpp"

namespace verdigris {

/// Parameters of Voronoi growth.
struct VoronoiParameters {
  double corner = 0.2071067811865476;

  template <typename V>
  void parameters(V&& v) {
    v("corner", corner, 0.0, 1.0, "1",
      "chance a step that a cell is filled from a corner neighbour; (sqrt(2) - 1) / 2 makes discs round");
  }
};

/// Regions growing from seeds until they meet; label k is seed k. Words of 32 bits hold arrival and label;
/// they widen to 64 by themselves should the steps outgrow them.
class VoronoiGrowth final : public AnySimulation {
 public:
  /// Throws InputError when there are no seeds, two in one cell, a weight that is not positive, or a seed on
  /// a barrier.
  VoronoiGrowth(const SimulationSetup& setup, const VoronoiParameters& parameters);

  StepReport step() override;
  bool finished() const override;
  std::uint64_t steps() const override;
  std::size_t bytes() const override;
  std::vector<FieldInfo> fields() const override;
  Field<std::int32_t> field(std::string_view name) const override;
  SavedState save() const override;
  void restore(const SavedState& saved) override;

  Field<std::int32_t> labels() const;    ///< [slot] label, -1 where growth did not come
  Field<std::int32_t> arrivals() const;  ///< [slot] step of arrival, 0 at seeds, -1 where growth did not come

 private:
  using Narrow = FrontStepper<VoronoiRule<std::uint32_t>>;
  using Wide = FrontStepper<VoronoiRule<std::uint64_t>>;
  template <typename Word>
  FrontStepper<VoronoiRule<Word>> start(const SimulationSetup& setup,
                                        const VoronoiParameters& parameters) const;
  template <typename Word>
  void restart(const SavedState& saved, const VoronoiRule<Word>& rule);
  void widen();

  const Surface& surface_;
  std::uint64_t seed_;
  std::size_t seed_count_;
  std::variant<std::monostate, Narrow, Wide> stepper_;
};

/// Cells for `count` seeds, uniform by area and different from each other, from random numbers keyed by
/// `seed`. Throws InputError when the surface has fewer cells, or fewer outside `barrier`.
std::vector<Seed> random_seeds(const Surface& surface, std::size_t count, std::uint64_t seed,
                               const Field<std::uint8_t>& barrier = {});

/// The catalogue entry of Voronoi growth.
BehaviourEntry voronoi_entry();

}  // namespace verdigris
