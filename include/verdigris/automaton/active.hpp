#pragma once
// Active rows: only rows near a change of the last step are evaluated. For behaviours that come to rest in
// most places, but not for good.

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <atomic>
#include <bit>
#include <cstddef>
#include <functional>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/row_evaluation.hpp"
#include "verdigris/automaton/row_stepper.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Runs an ActiveBehaviour. A step evaluates the active rows of cells, then writes those
/// that changed and makes the rows around them active, across edges through ghosts. A patch without an active
/// row costs next to nothing: rows are marked by a bit. Two state buffers. The same bits as SweepStepper. The
/// surface must outlive it.
template <ActiveBehaviour B>
class ActiveStepper : public RowStepper<B> {
 public:
  using State = typename B::State;
  using RowStepper<B>::RowStepper;

  /// Bytes of states and lists.
  std::size_t bytes() const {
    return RowStepper<B>::bytes() + active_.size() * sizeof(active_[0]) +
           (rows_.capacity() + changed_.capacity()) * sizeof(rows_[0]);
  }

  StepReport step() {
    if constexpr (SteppedBehaviour<B>) behaviour_.begin_step(step_ + 1);
    StepReport report{step_ + 1, 0, 0};
    list_active_rows();
    changed_.assign(rows_.size(), 0);
    report.visited = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, rows_.size(), 64), std::uint64_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t visited) {
          for (std::size_t k = range.begin(); k < range.end(); ++k) visited += evaluate(k);
          return visited;
        },
        std::plus<>());
    report.changed = tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, rows_.size(), 64), std::uint64_t{0},
        [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t changed) {
          for (std::size_t k = range.begin(); k < range.end(); ++k)
            if (changed_[k] != 0) {
              apply(rows_[k]);
              changed += changed_[k];
            }
          return changed;
        },
        std::plus<>());
    ++step_;
    report.changed +=
        this->make_pairs_common([&](std::uint32_t slot) { activate_around(surface_.row_of(slot)); });
    return report;
  }

 private:
  using RowStepper<B>::surface_;
  using RowStepper<B>::behaviour_;
  using RowStepper<B>::carrier_;
  using RowStepper<B>::state_;
  using RowStepper<B>::next_;
  using RowStepper<B>::seed_;
  using RowStepper<B>::step_;

  void list_active_rows() {
    rows_.clear();
    const std::size_t count = surface_.rows().size();
    for (std::size_t word = 0; word < active_.size(); ++word) {
      for (std::uint64_t rest = active_[word]; rest != 0; rest &= rest - 1) {
        const std::size_t row = 64 * word + static_cast<std::size_t>(std::countr_zero(rest));
        if (row < count) rows_.push_back(static_cast<std::uint32_t>(row));
      }
      active_[word] = 0;
    }
  }

  // Reads states, writes next ones. Returns how many cells the row has.
  std::uint64_t evaluate(std::size_t k) {
    const std::uint32_t r = rows_[k];
    const Row& row = surface_.rows()[r];
    if (row.run_begin == row.run_end) return 0;
    changed_[k] = static_cast<std::uint32_t>(
        evaluate_row(surface_, r, behaviour_, state_.data(), next_.data(), seed_, step_ + 1));
    if constexpr (FrontBehaviour<B>)
      if (changed_[k] == 0 && waits(r)) activate(r, r + 1);
    return row.run_end - row.run_begin;
  }

  bool waits(std::uint32_t r) const {
    const Row* row = surface_.rows().data() + r;
    for (std::uint32_t slot = row->run_begin; slot < row->run_end; ++slot)
      if (behaviour_.waits(neighbourhood_of(row, slot, state_.data()))) return true;
    return false;
  }

  // Writes what a row became, its own ghosts elsewhere with it: each slot has one writer.
  void apply(std::uint32_t r) {
    const Row& row = surface_.rows()[r];
    activate_around(r);
    const bool unfolded = surface_.link_kind() == LinkKind::unfolded;
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
      if (next_[slot] == state_[slot]) continue;
      state_[slot] = next_[slot];
      if (unfolded && surface_.links().is_source(slot))
        carrier_.carry(behaviour_, surface_.links().targets(slot), state_[slot],
                       [&](std::uint32_t ghost, State shown) {
                         state_[ghost] = shown;
                         activate_around(surface_.row_of(ghost));
                       });
    }
  }

  void activate_around(std::uint32_t r) { activate(r == 0 ? 0 : r - 1, r + 2); }
  void activate(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t r = begin; r < end && r < surface_.rows().size(); ++r) {
      const std::uint64_t bit = std::uint64_t{1} << (r & 63);
      std::atomic_ref<std::uint64_t> word(active_[r >> 6]);
      if ((word.load(std::memory_order_relaxed) & bit) == 0) word.fetch_or(bit, std::memory_order_relaxed);
    }
  }

  // [row / 64] to be looked at in the next step: at first every one.
  std::vector<std::uint64_t> active_ =
      std::vector<std::uint64_t>(surface_.rows().size() / 64 + 1, ~std::uint64_t{0});
  std::vector<std::uint32_t> rows_;     // those of this step
  std::vector<std::uint32_t> changed_;  // [k] cells of rows_[k] that changed
};

}  // namespace verdigris
