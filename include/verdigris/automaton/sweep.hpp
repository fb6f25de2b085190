#pragma once
// Full sweep: every cell, every step. What the other kinds of stepping are measured against.

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/row_evaluation.hpp"
#include "verdigris/automaton/row_stepper.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Runs any behaviour by evaluating every evolving cell in every step. The surface must outlive it.
template <Behaviour B>
class SweepStepper : public RowStepper<B> {
 public:
  using State = typename B::State;
  using RowStepper<B>::RowStepper;

  /// Bytes of states and of what finds ghosts.
  std::size_t bytes() const { return RowStepper<B>::bytes() + sources_.capacity() * sizeof(sources_[0]); }

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
    carrier_.refresh(behaviour_, state_, sources_);
    report.changed += this->make_pairs_common([](std::uint32_t) {});
    return report;
  }

  /// Sets an evolving cell to a state between two steps.
  void put(std::uint32_t slot, State state) {
    state_[slot] = state;
    if (surface_.link_kind() == LinkKind::unfolded)
      carrier_.carry(behaviour_, surface_.links().targets(slot), state,
                     [&](std::uint32_t ghost, State shown) { state_[ghost] = shown; });
  }

 private:
  using RowStepper<B>::surface_;
  using RowStepper<B>::behaviour_;
  using RowStepper<B>::carrier_;
  using RowStepper<B>::state_;
  using RowStepper<B>::next_;
  using RowStepper<B>::seed_;
  using RowStepper<B>::step_;

  struct Counts {
    std::uint64_t changed = 0, visited = 0;
  };

  // Of all ghosts; none where links make pairs.
  std::vector<std::uint32_t> sources_ = surface_.link_kind() == LinkKind::unfolded
                                            ? surface_.links().sources_of_targets()
                                            : std::vector<std::uint32_t>{};
};

}  // namespace verdigris
