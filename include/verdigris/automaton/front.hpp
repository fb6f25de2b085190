#pragma once
// Growth from a front: only cells that can change are visited, each a bounded number of times in all.

#include <tbb/global_control.h>
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

/// Runs a FrontBehaviour. A step evaluates the *candidates* (cells near a change, cells that wait), then
/// applies the changes and makes their neighbours candidates; ghosts carry a change across edges at once. A
/// StampedBehaviour does both in one pass, while the cells are at hand. One state buffer, one bit a slot
/// beside it. The same bits as SweepStepper. The surface must outlive it.
template <FrontBehaviour B>
class FrontStepper {
 public:
  using State = typename B::State;

  /// `state` as for SweepStepper. `sources`: evolving slots in whose neighbourhoods cells may change at
  /// first; with none given every cell is a candidate once.
  FrontStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               std::span<const std::uint32_t> sources = {})
      : surface_(surface), behaviour_(std::move(behaviour)), state_(std::move(state)), seed_(seed), step_(0) {
    refresh_ghosts();
    std::vector<std::uint32_t> starts(sources.begin(), sources.end());
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) {
        merges_ = merge_pairs(surface_, behaviour_, state_, paired_slots(surface_.links()));
        for (const auto& [slot, s] : merges_) {
          state_[slot] = s;
          starts.push_back(slot);
        }
      }
    mark_all_but_unsettled();
    if (sources.empty()) {
      consider_all();
      return;
    }
    for (const std::uint32_t slot : starts) {
      candidates_.reserve_more(most_marked);
      mark_around<false, false>(slot, surface_.row_of(slot), candidates_);
      spread_to_targets<false>(slot, candidates_);
    }
  }

  /// Goes on with a run that stands at `restart`: every cell is a candidate once, and pairs have been made
  /// common.
  FrontStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               const Restart& restart)
      : surface_(surface),
        behaviour_(std::move(behaviour)),
        state_(std::move(state)),
        seed_(seed),
        step_(restart.step) {
    refresh_ghosts();
    for (const std::uint32_t slot : restart.merged) merges_.emplace_back(slot, state_[slot]);
    mark_all_but_unsettled();
    consider_all();
  }

  /// No cell can change any more.
  bool finished() const { return candidates_.empty() && merges_.empty(); }

  StepReport step() {
    if constexpr (SteppedBehaviour<B>) behaviour_.begin_step(step_ + 1);
    StepReport report{step_ + 1, 0, candidates_.size()};
    // Small fronts are done before a second thread wakes.
    if (candidates_.size() < 2 * task_size || surface_.link_kind() == LinkKind::projected ||
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1)
      serial_step(report);
    else
      parallel_step(report);
    ++step_;
    return report;
  }

  const Field<State>& state() const { return state_; }
  Field<State> take_state() { return std::move(state_); }
  std::uint64_t steps() const { return step_; }
  Restart restart() const {
    Restart restart{step_, {}};
    for (const auto& merge : merges_) restart.merged.push_back(merge.first);
    return restart;
  }
  const B& behaviour() const { return behaviour_; }
  /// Bytes of state, marks and lists.
  std::size_t bytes() const {
    std::size_t sum = state_.capacity() * sizeof(State) + marks_.size() * sizeof(marks_[0]);
    sum += candidates_.bytes() + next_.bytes() + changes_.bytes();
    for (const auto& list : task_changes_) sum += list.bytes();
    for (const auto& list : task_next_) sum += list.bytes();
    return sum;
  }

 private:
  static constexpr std::size_t task_size = 4096;

  static constexpr std::size_t most_marked = 9;  // a slot and its neighbours
  static constexpr std::size_t ahead = 12;       // candidates fetched before their turn; flat from 8 to 24

  struct Place {
    std::uint32_t row, slot;
  };
  struct Change {
    std::uint32_t row, slot;
    State state;
  };

  // A list that is written without branches: room is made first, then elements are put and counted or not.
  template <typename T>
  class List {
   public:
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t bytes() const { return room_.size() * sizeof(T); }
    void clear() { size_ = 0; }
    void reserve_more(std::size_t more) {
      if (room_.size() < size_ + more) room_.resize(std::max(size_ + more, room_.size() + room_.size() / 2));
    }
    void put_if(const T& value, bool counts) {
      room_[size_] = value;
      size_ += counts;
    }
    void push(const T& value) {
      reserve_more(1);
      put_if(value, true);
    }
    void append(const List& other) {
      reserve_more(other.size_);
      std::copy_n(other.room_.begin(), other.size_, room_.begin() + static_cast<std::ptrdiff_t>(size_));
      size_ += other.size_;
    }
    template <typename Keep>
    void keep_if(Keep&& keep) {
      size_ = static_cast<std::size_t>(std::remove_if(room_.begin(),
                                                      room_.begin() + static_cast<std::ptrdiff_t>(size_),
                                                      [&](const T& t) { return !keep(t); }) -
                                       room_.begin());
    }
    const T* begin() const { return room_.data(); }
    const T* end() const { return room_.data() + size_; }

   private:
    std::vector<T> room_;
    std::size_t size_ = 0;
  };

  void serial_step(StepReport& report) {
    changes_.clear();
    next_.clear();
    if (in_place()) {
      report.changed = advance<false>(candidates_.begin(), candidates_.end(), next_);
    } else {
      evaluate<false>(candidates_.begin(), candidates_.end(), changes_, next_);
      apply<false>(changes_, next_);
      report.changed = changes_.size();
    }
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) report.changed += make_pairs_common();
    std::swap(candidates_, next_);
  }

  void parallel_step(StepReport& report) {
    const std::size_t tasks = (candidates_.size() + task_size - 1) / task_size;
    task_changes_.resize(std::max(tasks, task_changes_.size()));
    task_next_.resize(std::max(tasks, task_next_.size()));
    std::vector<std::uint64_t> changed(tasks);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
      task_changes_[task].clear();
      task_next_[task].clear();
      const Place* begin = candidates_.begin() + task * task_size;
      const Place* end = std::min(begin + task_size, candidates_.end());
      if (in_place())
        changed[task] = advance<true>(begin, end, task_next_[task]);
      else
        evaluate<true>(begin, end, task_changes_[task], task_next_[task]);
    });
    if (!in_place())
      tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        apply<true>(task_changes_[task], task_next_[task]);
        changed[task] = task_changes_[task].size();
      });
    candidates_.clear();
    for (std::size_t task = 0; task < tasks; ++task) {
      report.changed += changed[task];
      candidates_.append(task_next_[task]);
    }
  }

  // Pairs are merged from the states before a turn: those need the two passes.
  bool in_place() const {
    if constexpr (StampedBehaviour<B>)
      return behaviour_.in_place() && surface_.link_kind() == LinkKind::unfolded;
    else
      return false;
  }

  // Base offsets wrap around: the pointers are formed from 32-bit slots.
  Neighbourhood<State> around(const Place& place) const {
    const Row* row = surface_.rows().data() + place.row;
    const std::uint32_t column = place.slot - row->base;
    const State* state = state_.data();
    return {state + static_cast<std::uint32_t>(row[-1].base + column), state + place.slot,
            state + static_cast<std::uint32_t>(row[1].base + column)};
  }

  // The rows' own cache lines come with the nearer fetch.
  void fetch(const Place* place, const Place* end) const {
    if (static_cast<std::size_t>(end - place) <= ahead) return;
    __builtin_prefetch(state_.data() + place[ahead].slot, 1);
    const auto n = around(place[ahead / 2]);
    __builtin_prefetch(n.below);
    __builtin_prefetch(n.above);
  }

  // One pass: evaluate, write, spread. Other threads may read a state while it is written; they take it for
  // what it was before either way.
  template <bool Shared>
  std::uint64_t advance(const Place* begin, const Place* end, List<Place>& next) {
    const Links& links = surface_.links();
    constexpr std::ptrdiff_t block = 256;  // room is made block by block
    std::uint64_t changed = 0;
    while (begin != end) {
      const Place* stop = begin + std::min(block, end - begin);
      next.reserve_more(block * most_marked);
      for (; begin != stop; ++begin) {
        fetch(begin, end);
        const Place place = *begin;
        const State state = behaviour_.next(around(place), CellRandom(seed_, step_ + 1, place.slot));
        if (state == state_[place.slot]) {
          next.put_if(place, true);  // it waits
          continue;
        }
        ++changed;
        store<Shared>(place.slot, state);
        mark_around<Shared, false>(place.slot, place.row, next);
        if (links.is_source(place.slot)) {
          const auto ghosts = links.targets(place.slot);
          next.reserve_more((block + ghosts.size()) * most_marked);
          for (const std::uint32_t ghost : ghosts) {
            store<Shared>(ghost, state);
            mark_around<Shared, true>(ghost, surface_.row_of(ghost), next);
          }
        }
      }
    }
    return changed;
  }

  template <bool Shared>
  void store(std::uint32_t slot, State state) {
    if constexpr (Shared)
      std::atomic_ref<State>(state_[slot]).store(state, std::memory_order_relaxed);
    else
      state_[slot] = state;
  }

  // Reads states only; the order of candidates cannot matter.
  template <bool Shared>
  void evaluate(const Place* begin, const Place* end, List<Change>& changes, List<Place>& waiting) {
    const auto count = static_cast<std::size_t>(end - begin);
    changes.reserve_more(count + 1);
    waiting.reserve_more(count + 1);
    for (const Place* place = begin; place != end; ++place) {
      fetch(place, end);
      const auto n = around(*place);
      const State next = behaviour_.next(n, CellRandom(seed_, step_ + 1, place->slot));
      const bool changed = next != *n.here;
      const bool waits = !changed && behaviour_.waits(n);
      changes.put_if({place->row, place->slot, next}, changed);
      waiting.put_if(*place, waits);
      if (!waits && !behaviour_.settled(next)) unmark<Shared>(place->slot);
    }
  }

  template <bool Shared>
  void apply(const List<Change>& changes, List<Place>& next) {
    const bool unfolded = surface_.link_kind() == LinkKind::unfolded;
    const Links& links = surface_.links();
    constexpr std::size_t block = 256;  // room is made block by block
    for (const Change* change = changes.begin(); change != changes.end();) {
      const Change* stop =
          change + std::min<std::size_t>(block, static_cast<std::size_t>(changes.end() - change));
      next.reserve_more(block * most_marked);
      for (; change != stop; ++change) {
        state_[change->slot] = change->state;
        mark_around<Shared, false>(change->slot, change->row, next);
        if (unfolded && links.is_source(change->slot)) {
          for (const std::uint32_t ghost : links.targets(change->slot)) state_[ghost] = change->state;
          spread_to_targets<Shared>(change->slot, next);
          next.reserve_more(block * most_marked);
        }
      }
    }
  }

  // Pairs are made common for what changed in this turn, and for what cells took from partners in the one
  // before.
  std::uint64_t make_pairs_common() requires MergingBehaviour<B> {
    std::vector<std::uint32_t> sources;
    for (const Change& change : changes_) sources.push_back(change.slot);
    for (const auto& [slot, state] : merges_) sources.push_back(slot);
    merges_ = merge_pairs(surface_, behaviour_, state_, sources);
    for (const auto& [slot, state] : merges_) {
      state_[slot] = state;
      if (behaviour_.settled(state)) marks_[slot >> 6] |= std::uint64_t{1} << (slot & 63);
    }
    for (const auto& merge : merges_) {
      next_.reserve_more(most_marked);
      mark_around<false, true>(merge.first, surface_.row_of(merge.first), next_);
    }
    // A candidate that a partner settled is no candidate any more.
    next_.keep_if([&](const Place& place) { return !behaviour_.settled(state_[place.slot]); });
    return merges_.size();
  }

  template <bool Shared>
  void spread_to_targets(std::uint32_t slot, List<Place>& next) {
    const auto targets = surface_.links().targets(slot);
    next.reserve_more((targets.size() + 1) * most_marked);
    for (const std::uint32_t target : targets)
      mark_around<Shared, true>(target, surface_.row_of(target), next);
  }

  // Makes the unmarked ones of a slot and its eight neighbours candidates; `next` has room for them.
  template <bool Shared, bool Ghost>
  void mark_around(std::uint32_t slot, std::uint32_t row, List<Place>& next) {
    const Row* rows = surface_.rows().data() + row;
    const std::uint32_t column = slot - rows[0].base;
    for (int d = -1; d <= 1; ++d) {
      const Row& r = rows[d];
      const std::uint32_t first = r.base + column - 1;
      std::uint32_t wanted = 7;
      if constexpr (Ghost) {
        // Around a ghost the row may end before the column: those slots belong to another row, and may evolve
        // there.
        wanted = 0;
        for (std::uint32_t k = 0; k < 3; ++k)
          wanted |= static_cast<std::uint32_t>(first + k - r.run_begin < r.run_end - r.run_begin) << k;
        if (wanted == 0) continue;
      }
      const std::uint32_t fresh = test_and_mark<Shared>(first, wanted);
      const std::uint32_t index = row + static_cast<std::uint32_t>(d);
      next.put_if({index, first}, (fresh & 1u) != 0);
      next.put_if({index, first + 1}, (fresh & 2u) != 0);
      next.put_if({index, first + 2}, (fresh & 4u) != 0);
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

  void refresh_ghosts() {
    if (surface_.link_kind() != LinkKind::unfolded) return;
    surface_.links().for_each([&](std::uint32_t source, auto targets) {
      for (const std::uint32_t ghost : targets) state_[ghost] = state_[source];
    });
  }

  // A marked slot never becomes a candidate: it is one, it does not evolve, or it is settled.
  void mark_all_but_unsettled() {
    marks_.assign(surface_.slot_count() / 64 + 2, ~std::uint64_t{0});
    for (const Row& row : surface_.rows()) unmark_unsettled(row.run_begin, row.run_end);
  }

  // In place, only cells that wait may be candidates: a change beside any other makes it one.
  void consider_all() {
    const auto rows = surface_.rows();
    for (std::uint32_t r = 0; r < rows.size(); ++r)
      for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
        if ((!StampedBehaviour<B> || behaviour_.waits(around({r, slot}))) &&
            test_and_mark<false>(slot, 1u) != 0)
          candidates_.push({r, slot});
  }

  void unmark_unsettled(std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t slot = begin; slot < end;) {
      const std::uint32_t stop = std::min(end, (slot | 63u) + 1u);
      std::uint64_t open = 0;
      for (std::uint32_t s = slot; s < stop; ++s)
        open |= std::uint64_t{!behaviour_.settled(state_[s])} << (s & 63u);
      marks_[slot >> 6] &= ~open;
      slot = stop;
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
  List<Place> candidates_, next_;
  List<Change> changes_;
  std::vector<List<Change>> task_changes_;
  std::vector<List<Place>> task_next_;
  Merges<State> merges_;  // what pairs made common in the last turn
};

}  // namespace verdigris
