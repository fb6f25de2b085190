#pragma once
// Full sweep: every cell, every step. What the other kinds of stepping are measured against.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>
#include <utility>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/ghost_carrier.hpp"
#include "verdigris/automaton/pairs.hpp"
#include "verdigris/automaton/row_evaluation.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Runs any behaviour by evaluating every evolving cell in every step. The surface must outlive it.
template <Behaviour B>
class SweepStepper {
 public:
  using State = typename B::State;

  /// `state` holds a value for each slot of the surface; those of ghosts are made anew from their owners.
  SweepStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed)
      : SweepStepper(surface, std::move(behaviour), std::move(state), seed, Restart{}) {
    make_pairs_common();
    next_ = state_;
  }

  /// Goes on with a run that stands at `restart`; there the pairs have been made common.
  SweepStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               const Restart& restart)
      : surface_(surface),
        behaviour_(std::move(behaviour)),
        carrier_(surface),
        state_(std::move(state)),
        seed_(seed),
        step_(restart.step) {
    refresh_ghosts();
    next_ = state_;
  }

  StepReport step() {
    if constexpr (SteppedBehaviour<B>) behaviour_.begin_step(step_ + 1);
    StepReport report{step_ + 1, 0, 0};
    const auto rows = surface_.rows();
    const auto total = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, rows.size(), 64), Counts{},
        [&](const tbb::blocked_range<std::size_t>& range, Counts counts) {
          for (std::size_t r = range.begin(); r < range.end(); ++r)
            if (rows[r].run_begin != rows[r].run_end) {
              counts.changed += evaluate_row(surface_, static_cast<std::uint32_t>(r), behaviour_,
                                             state_.data(), next_.data(), seed_, step_ + 1);
              counts.visited += rows[r].run_end - rows[r].run_begin;
            }
          return counts;
        },
        [](Counts a, Counts b) {
          return Counts{a.changed + b.changed, a.visited + b.visited};
        });
    state_.swap(next_);
    ++step_;
    report.changed = total.changed;
    report.visited = total.visited;
    refresh_ghosts();
    report.changed += make_pairs_common();
    return report;
  }

  /// Sets an evolving cell to a state between two steps.
  void put(std::uint32_t slot, State state) {
    state_[slot] = state;
    if (surface_.link_kind() == LinkKind::unfolded)
      carrier_.carry(behaviour_, surface_.links().targets(slot), state,
                     [&](std::uint32_t ghost, State shown) { state_[ghost] = shown; });
  }

  const Field<State>& state() const { return state_; }
  std::uint64_t steps() const { return step_; }
  Restart restart() const { return {step_, {}}; }
  const B& behaviour() const { return behaviour_; }

 private:
  struct Counts {
    std::uint64_t changed = 0, visited = 0;
  };

  void refresh_ghosts() {
    if (surface_.link_kind() != LinkKind::unfolded) return;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface_.links().word_count(), 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        carrier_.refresh_between(behaviour_, state_, range.begin(), range.end());
                      });
  }

  std::uint64_t make_pairs_common() {
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) {
        const auto merges = merge_pairs(surface_, behaviour_, state_, paired_slots(surface_.links()));
        for (const auto& [slot, state] : merges) state_[slot] = state;
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
