#pragma once
// Growth from a front: only cells that can change are visited, each a bounded number of times in all.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/pairs.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Runs a FrontBehaviour. A step evaluates the *candidates* (cells near a change, cells that wait), then applies the
/// changes and makes their neighbours candidates; ghosts carry a change across edges at once. One state buffer, one
/// bit a slot beside it. The same bits as SweepStepper. The surface must outlive it.
template <FrontBehaviour B>
class FrontStepper {
 public:
  using State = typename B::State;

  /// `state` as for SweepStepper. `sources`: evolving slots in whose neighbourhoods cells may change at first; with none
  /// given every cell is a candidate once (after a restart, say).
  FrontStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               std::span<const std::uint32_t> sources = {}, std::uint64_t step = 0)
      : surface_(surface), behaviour_(std::move(behaviour)), state_(std::move(state)), seed_(seed), step_(step) {
    if (surface_.link_kind() == LinkKind::unfolded)
      surface_.links().for_each([&](std::uint32_t source, auto targets) {
        for (const std::uint32_t ghost : targets) state_[ghost] = state_[source];
      });
    std::vector<std::uint32_t> starts(sources.begin(), sources.end());
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) {
        merges_ = merge_pairs(surface_, behaviour_, state_, paired_slots(surface_.links()));
        for (const auto& [slot, s] : merges_) {
          state_[slot] = s;
          starts.push_back(slot);
        }
      }
    // A marked slot never becomes a candidate: it is one, it does not evolve, or it is settled.
    marks_.assign(surface_.slot_count() / 64 + 2, ~std::uint64_t{0});
    const auto rows = surface_.rows();
    for (std::uint32_t r = 0; r < rows.size(); ++r)
      for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
        if (!behaviour_.settled(state_[slot])) marks_[slot >> 6] &= ~(std::uint64_t{1} << (slot & 63));
    if (sources.empty()) {
      for (std::uint32_t r = 0; r < rows.size(); ++r)
        for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
          if (test_and_mark<false>(slot, 1u)) candidates_.push_back({r, slot});
    } else {
      for (const std::uint32_t slot : starts) spread_from<false>(slot, surface_.row_of(slot), candidates_);
    }
  }

  /// No cell can change any more.
  bool finished() const { return candidates_.empty() && merges_.empty(); }

  StepReport step() {
    if constexpr (SteppedBehaviour<B>) behaviour_.begin_step(step_ + 1);
    StepReport report{step_ + 1, 0, candidates_.size()};
    // Small fronts are done before a second thread wakes.
    if (candidates_.size() < 2 * task_size || surface_.link_kind() == LinkKind::projected)
      serial_step(report);
    else
      parallel_step(report);
    ++step_;
    return report;
  }

  const Field<State>& state() const { return state_; }
  Field<State> take_state() { return std::move(state_); }
  std::uint64_t steps() const { return step_; }
  const B& behaviour() const { return behaviour_; }
  /// Bytes of state, marks and lists.
  std::size_t bytes() const {
    return state_.capacity() * sizeof(State) + marks_.size() * 8 + candidates_.capacity() * sizeof(Place) +
           changes_.capacity() * sizeof(Change) + next_.capacity() * sizeof(Place);
  }

 private:
  static constexpr std::size_t task_size = 4096;

  struct Place {
    std::uint32_t row, slot;
  };
  struct Change {
    std::uint32_t row, slot;
    State state;
  };

  void serial_step(StepReport& report) {
    changes_.clear();
    next_.clear();
    evaluate<false>(candidates_, changes_, next_);
    apply<false>(changes_, next_);
    report.changed = changes_.size();
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) report.changed += make_pairs_common();
    candidates_.swap(next_);
  }

  void parallel_step(StepReport& report) {
    const std::size_t tasks = (candidates_.size() + task_size - 1) / task_size;
    std::vector<std::vector<Change>> changes(tasks);
    std::vector<std::vector<Place>> next(tasks);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
      const std::size_t begin = task * task_size, end = std::min(candidates_.size(), begin + task_size);
      evaluate<true>(std::span<const Place>(candidates_).subspan(begin, end - begin), changes[task], next[task]);
    });
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) { apply<true>(changes[task], next[task]); });
    candidates_.clear();
    for (std::size_t task = 0; task < tasks; ++task) {
      report.changed += changes[task].size();
      candidates_.insert(candidates_.end(), next[task].begin(), next[task].end());
    }
  }

  // Reads states only; the order of candidates cannot matter.
  template <bool Shared>
  void evaluate(std::span<const Place> candidates, std::vector<Change>& changes, std::vector<Place>& waiting) {
    const Row* rows = surface_.rows().data();
    const State* state = state_.data();
    for (const Place& place : candidates) {
      const std::uint32_t column = place.slot - rows[place.row].base;
      // Base offsets wrap around: the pointer is formed from the 32-bit slot.
      const Neighbourhood<State> n{state + static_cast<std::uint32_t>((rows + place.row)[-1].base + column),
                                   state + place.slot,
                                   state + static_cast<std::uint32_t>(rows[place.row + 1].base + column)};
      const State next = behaviour_.next(n, CellRandom(seed_, step_ + 1, place.slot));
      if (next != *n.here) {
        changes.push_back({place.row, place.slot, next});
        if (!behaviour_.settled(next)) unmark<Shared>(place.slot);
      } else if (behaviour_.waits(n)) {
        waiting.push_back(place);
      } else {
        unmark<Shared>(place.slot);
      }
    }
  }

  template <bool Shared>
  void apply(const std::vector<Change>& changes, std::vector<Place>& next) {
    const bool unfolded = surface_.link_kind() == LinkKind::unfolded;
    const Links& links = surface_.links();
    for (const Change& change : changes) {
      state_[change.slot] = change.state;
      mark_around<Shared>(change.slot, change.row, next);
      if (unfolded)
        for (const std::uint32_t ghost : links.targets(change.slot)) {
          state_[ghost] = change.state;
          mark_around<Shared>(ghost, surface_.row_of(ghost), next);
        }
    }
  }

  // Pairs are made common for what changed in this turn, and for what cells took from partners in the one before.
  std::uint64_t make_pairs_common()
    requires MergingBehaviour<B>
  {
    std::vector<std::uint32_t> sources;
    for (const Change& change : changes_) sources.push_back(change.slot);
    for (const auto& [slot, state] : merges_) sources.push_back(slot);
    merges_ = merge_pairs(surface_, behaviour_, state_, sources);
    for (const auto& [slot, state] : merges_) {
      state_[slot] = state;
      if (behaviour_.settled(state)) marks_[slot >> 6] |= std::uint64_t{1} << (slot & 63);
    }
    for (const auto& merge : merges_) mark_around<false>(merge.first, surface_.row_of(merge.first), next_);
    // A candidate that a partner settled is no candidate any more.
    std::erase_if(next_, [&](const Place& place) { return behaviour_.settled(state_[place.slot]); });
    return merges_.size();
  }

  template <bool Shared>
  void spread_from(std::uint32_t slot, std::uint32_t row, std::vector<Place>& next) {
    mark_around<Shared>(slot, row, next);
    for (const std::uint32_t target : surface_.links().targets(slot))
      mark_around<Shared>(target, surface_.row_of(target), next);
  }

  // Makes the unmarked ones of a slot and its eight neighbours candidates.
  template <bool Shared>
  void mark_around(std::uint32_t slot, std::uint32_t row, std::vector<Place>& next) {
    const Row* rows = surface_.rows().data() + row;
    const std::uint32_t column = slot - rows[0].base;
    for (int d = -1; d <= 1; ++d) {
      // Around a ghost the row may end before the column: those slots belong to another row, and evolve there.
      const Row& r = rows[d];
      std::uint32_t first = r.base + column - 1, wanted = 7u;
      if (first - r.run_begin >= r.run_end - r.run_begin || first + 2 >= r.run_end) {
        wanted = 0;
        for (std::uint32_t k = 0; k < 3; ++k)
          if (first + k - r.run_begin < r.run_end - r.run_begin) wanted |= 1u << k;
        if (wanted == 0) continue;
      }
      for (std::uint32_t fresh = test_and_mark<Shared>(first, wanted); fresh != 0; fresh &= fresh - 1)
        next.push_back({row + static_cast<std::uint32_t>(d), first + static_cast<std::uint32_t>(std::countr_zero(fresh))});
    }
  }

  // Of the `wanted` (one bit each) slots from `first` on, those that were not marked; they are now.
  template <bool Shared>
  std::uint32_t test_and_mark(std::uint32_t first, std::uint32_t wanted) {
    const std::size_t word = first >> 6;
    const unsigned shift = first & 63;
    std::uint64_t low = std::uint64_t{wanted} << shift;
    std::uint64_t fresh = claim<Shared>(marks_[word], low) >> shift;
    if (shift > 61) {
      const std::uint64_t high = std::uint64_t{wanted} >> (64 - shift);
      if (high != 0) fresh |= claim<Shared>(marks_[word + 1], high) << (64 - shift);
    }
    return static_cast<std::uint32_t>(fresh);
  }

  template <bool Shared>
  static std::uint64_t claim(std::uint64_t& word, std::uint64_t bits) {
    if constexpr (Shared) {
      std::atomic_ref<std::uint64_t> shared(word);
      const std::uint64_t missing = bits & ~shared.load(std::memory_order_relaxed);
      return missing == 0 ? 0 : bits & ~shared.fetch_or(missing, std::memory_order_relaxed);
    } else {
      const std::uint64_t fresh = bits & ~word;
      word |= bits;
      return fresh;
    }
  }

  template <bool Shared>
  void unmark(std::uint32_t slot) {
    const std::uint64_t keep = ~(std::uint64_t{1} << (slot & 63));
    if constexpr (Shared)
      std::atomic_ref<std::uint64_t>(marks_[slot >> 6]).fetch_and(keep, std::memory_order_relaxed);
    else
      marks_[slot >> 6] &= keep;
  }

  const Surface& surface_;
  B behaviour_;
  Field<State> state_;
  std::uint64_t seed_, step_;
  std::vector<std::uint64_t> marks_;  // [slot / 64]
  std::vector<Place> candidates_, next_;
  std::vector<Change> changes_;
  Merges<State> merges_;  // what pairs made common in the last turn
};

}  // namespace verdigris
