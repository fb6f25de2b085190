#pragma once
// What the steppers that go by rows share: a state, the next one beside it, and how both follow the links.

#include <cstdint>
#include <utility>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/ghost_carrier.hpp"
#include "verdigris/automaton/pairs.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Base of SweepStepper and ActiveStepper. The surface must outlive it.
template <Behaviour B>
class RowStepper {
 public:
  using State = typename B::State;

  /// `state` holds a value for each slot of the surface; those of ghosts are made anew from their owners.
  RowStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed)
      : RowStepper(surface, std::move(behaviour), std::move(state), seed, Restart{}) {
    make_pairs_common([&](std::uint32_t slot) { next_[slot] = state_[slot]; });
  }

  /// Goes on with a run that stands at `restart`; there the pairs have been made common.
  RowStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
             const Restart& restart)
      : surface_(surface),
        behaviour_(std::move(behaviour)),
        carrier_(surface),
        state_(std::move(state)),
        seed_(seed),
        step_(restart.step) {
    carrier_.refresh(behaviour_, state_);
    next_ = large_copy(state_);
  }

  const Field<State>& state() const { return state_; }
  std::uint64_t steps() const { return step_; }
  Restart restart() const { return {step_, {}}; }
  const B& behaviour() const { return behaviour_; }
  /// Bytes of states.
  std::size_t bytes() const {
    return (state_.capacity() + next_.capacity()) * sizeof(State) + carrier_.bytes();
  }

 protected:
  /// Calls changed(slot) for each cell that took a partner's state; returns how many did.
  template <typename Changed>
  std::uint64_t make_pairs_common(Changed&& changed) {
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) {
        const auto merges = merge_pairs(surface_, behaviour_, state_, paired_slots(surface_.links()));
        for (const auto& [slot, state] : merges) {
          state_[slot] = state;
          changed(slot);
        }
        return merges.size();
      }
    return 0;
  }

  const Surface& surface_;
  B behaviour_;
  GhostCarrier<B> carrier_;
  Field<State> state_, next_;
  std::uint64_t seed_, step_;
};

}  // namespace verdigris
