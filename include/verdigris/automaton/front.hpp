#pragma once
// Growth from a front: only cells that can change are visited, each a bounded number of times in all.

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "verdigris/automaton/alarms.hpp"
#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/automaton/ghost_carrier.hpp"
#include "verdigris/automaton/pairs.hpp"
#include "verdigris/automaton/row_evaluation.hpp"
#include "verdigris/automaton/slot_list.hpp"
#include "verdigris/automaton/slot_marks.hpp"
#include "verdigris/base/prefetch.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Runs a FrontBehaviour. A step evaluates the *candidates* (cells near a change, cells that wait), then
/// applies the changes and makes their neighbours candidates; ghosts carry a change across edges at once. A
/// StampedBehaviour does both in one pass, while the cells are at hand; a WakingBehaviour makes candidates
/// only where a change wakes, a TimedBehaviour also when an alarm goes off. One state buffer, one bit a slot
/// beside it. The same bits as SweepStepper. The surface must outlive it.
template <FrontBehaviour B>
class FrontStepper {
 public:
  using State = typename B::State;

  /// `state` as for SweepStepper. `sources`: evolving slots in whose neighbourhoods cells may change at
  /// first; with none given every cell is a candidate once.
  FrontStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               std::span<const std::uint32_t> sources = {})
      : surface_(surface),
        behaviour_(std::move(behaviour)),
        carrier_(surface),
        state_(std::move(state)),
        seed_(seed),
        step_(0),
        marks_(surface) {
    carrier_.refresh(behaviour_, state_);
    std::vector<std::uint32_t> starts(sources.begin(), sources.end());
    if constexpr (MergingBehaviour<B>)
      if (surface_.link_kind() == LinkKind::projected) {
        merges_ = merge_pairs(surface_, behaviour_, state_, paired_slots(surface_.links()));
        for (const auto& [slot, s] : merges_) {
          state_[slot] = s;
          starts.push_back(slot);
        }
      }
    unmark_unsettled();
    set_alarms();
    if (sources.empty()) {
      consider_all();
      return;
    }
    for (const std::uint32_t slot : starts) wake(slot);
  }

  /// Goes on with a run that stands at `restart`: every cell is a candidate once, and pairs have been made
  /// common.
  FrontStepper(const Surface& surface, B behaviour, Field<State> state, std::uint64_t seed,
               const Restart& restart)
      : surface_(surface),
        behaviour_(std::move(behaviour)),
        carrier_(surface),
        state_(std::move(state)),
        seed_(seed),
        step_(restart.step),
        marks_(surface) {
    carrier_.refresh(behaviour_, state_);
    for (const std::uint32_t slot : restart.merged) merges_.emplace_back(slot, state_[slot]);
    unmark_unsettled();
    set_alarms();
    consider_all();
  }

  /// No cell can change any more.
  bool finished() const {
    if (!candidates_.empty() || !merges_.empty()) return false;
    return !any_alarm();
  }
  /// Some cell will have to be looked at in a later step, whatever happens around it.
  bool any_alarm() const {
    if constexpr (TimedBehaviour<B>)
      return alarms_.any([&](std::uint32_t slot) { return behaviour_.alarm(state_[slot]) > step_; });
    return false;
  }

  StepReport step() {
    if constexpr (SteppedBehaviour<B>) behaviour_.begin_step(step_ + 1);
    alarms_.take([&](std::uint32_t slot) {
      if (marks_.test_and_mark<false>(slot, 1u) != 0) candidates_.push({surface_.row_of(slot), slot});
    });
    StepReport report{step_ + 1, 0, candidates_.size()};
    // Small fronts are done before a second thread wakes.
    if (candidates_.size() < 2 * task_size || surface_.link_kind() == LinkKind::projected ||
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism) == 1)
      serial_step(report);
    else
      parallel_step(report);
    ++step_;
    if constexpr (TimedBehaviour<B>)
      visit_changes([&](std::uint32_t slot, State state) { set_alarm(slot, state); });
    return report;
  }

  /// Sets an evolving cell to a state between two steps, and wakes what is around it.
  void put(std::uint32_t slot, State state) {
    state_[slot] = state;
    if (surface_.link_kind() == LinkKind::unfolded)
      carrier_.carry(behaviour_, surface_.links().targets(slot), state,
                     [&](std::uint32_t ghost, State shown) { state_[ghost] = shown; });
    wake(slot);
    set_alarm(slot, state);
  }

  /// Calls visit(slot, state) for each cell that changed in the last step, in no order that means anything.
  /// Only after two passes: not for a StampedBehaviour, nor for what pairs made common.
  template <typename Visit>
  void visit_changes(Visit&& visit) const requires(!StampedBehaviour<B>) {
    for (const Change& change : changes_) visit(change.slot, change.state);
    for (std::size_t task = 0; task < tasks_; ++task)
      for (const Change& change : task_changes_[task]) visit(change.slot, change.state);
  }

  /// Whether which(neighbourhood) holds for any cell that the next step will evaluate.
  template <typename Which>
  bool any_candidate(Which&& which) const {
    return std::any_of(candidates_.begin(), candidates_.end(),
                       [&](const Place& place) { return which(around(place)); });
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
    std::size_t sum = state_.capacity() * sizeof(State) + marks_.bytes() + carrier_.bytes() + alarms_.bytes();
    sum += candidates_.bytes() + next_.bytes() + changes_.bytes();
    for (const auto& list : task_changes_) sum += list.bytes();
    for (const auto& list : task_next_) sum += list.bytes();
    return sum;
  }

 private:
  static constexpr std::size_t task_size = 4096;

  static constexpr std::size_t most_marked = SlotMarks::most_marked;
  // Candidates fetched before their turn; as good from 12, 6, 3 to 32, 20, 10.
  static constexpr std::ptrdiff_t far_ahead = 18, nearer_ahead = 10, next_ahead = 4;

  struct Change {
    std::uint32_t row, slot;
    State state;
  };
  using Places = SlotList<Place>;
  using Changes = SlotList<Change>;

  void serial_step(StepReport& report) {
    changes_.clear();
    next_.clear();
    tasks_ = 0;
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
    tasks_ = tasks;
    changes_.clear();
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

  Neighbourhood<State> around(const Place& place) const {
    return neighbourhood_of(surface_.rows().data() + place.row, place.slot, state_.data());
  }

  // In three turns, each of which asks for what the next one goes by: a cell, its row and links; the rows
  // beside it and its ghosts' slots; the ghosts.
  [[gnu::always_inline]] void fetch(const Place* place, const Place* end) const {
    if (end - place <= far_ahead) return;
    const Links& links = surface_.links();
    const Place& far = place[far_ahead];
    prefetch_for_writing(state_.data() + far.slot);
    prefetch(surface_.rows().data() + far.row);
    links.prefetch_source(far.slot);

    const Place& nearer = place[nearer_ahead];
    const auto n = around(nearer);
    prefetch(n.below);
    prefetch(n.above);
    marks_.prefetch_mark(nearer.slot);
    links.prefetch_targets(nearer.slot);

    const Place& next = place[next_ahead];
    if (!links.is_source(next.slot)) return;
    const std::uint32_t ghost = links.likely_target(next.slot);
    prefetch_for_writing(state_.data() + ghost);
    surface_.prefetch_row_of(ghost);
    marks_.prefetch_mark(ghost);
  }

  // One pass: evaluate, write, spread. Other threads may read a state while it is written; they take it for
  // what it was before either way.
  template <bool Shared>
  std::uint64_t advance(const Place* begin, const Place* end, Places& next) {
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
        marks_.mark_around<Shared, false>(place.slot, place.row, next);
        if (links.is_source(place.slot)) {
          const auto ghosts = links.targets(place.slot);
          next.reserve_more((block + ghosts.size()) * most_marked);
          carrier_.carry(behaviour_, ghosts, state, [&](std::uint32_t ghost, State shown) {
            store<Shared>(ghost, shown);
            marks_.mark_around<Shared, true>(ghost, surface_.row_of(ghost), next);
          });
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
  void evaluate(const Place* begin, const Place* end, Changes& changes, Places& waiting) {
    const auto count = static_cast<std::size_t>(end - begin);
    changes.reserve_more(count + 1);
    waiting.reserve_more(count + 1);
    for (const Place* place = begin; place != end; ++place) {
      fetch(place, end);
      const auto n = around(*place);
      const State next = behaviour_.next(n, CellRandom(seed_, step_ + 1, place->slot));
      const bool changed = next != *n.here;
      bool waits = false;
      if constexpr (WakingBehaviour<B>)
        waits = !(changed && behaviour_.wakes(*n.here, next)) && !behaviour_.settled(next) &&
                behaviour_.still_waits(n, next);
      else
        waits = !changed && behaviour_.waits(n);
      changes.put_if({place->row, place->slot, next}, changed);
      waiting.put_if(*place, waits);
      if (!waits && !behaviour_.settled(next)) marks_.unmark<Shared>(place->slot);
    }
  }

  template <bool Shared>
  void apply(const Changes& changes, Places& next) {
    const bool unfolded = surface_.link_kind() == LinkKind::unfolded;
    const Links& links = surface_.links();
    constexpr std::size_t block = 256;  // room is made block by block
    for (const Change* change = changes.begin(); change != changes.end();) {
      const Change* stop =
          change + std::min<std::size_t>(block, static_cast<std::size_t>(changes.end() - change));
      next.reserve_more(block * most_marked);
      for (; change != stop; ++change) {
        bool wakes = true;
        if constexpr (WakingBehaviour<B>) wakes = behaviour_.wakes(state_[change->slot], change->state);
        state_[change->slot] = change->state;
        if (wakes) marks_.mark_around<Shared, false>(change->slot, change->row, next);
        if (unfolded && links.is_source(change->slot)) {
          carrier_.carry(behaviour_, links.targets(change->slot), change->state,
                         [&](std::uint32_t ghost, State shown) { state_[ghost] = shown; });
          if (!wakes) continue;
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
      if (behaviour_.settled(state)) marks_.mark(slot);
    }
    for (const auto& merge : merges_) {
      next_.reserve_more(most_marked);
      marks_.mark_around<false, true>(merge.first, surface_.row_of(merge.first), next_);
    }
    // A candidate that a partner settled is no candidate any more.
    next_.keep_if([&](const Place& place) { return !behaviour_.settled(state_[place.slot]); });
    return merges_.size();
  }

  template <bool Shared>
  void spread_to_targets(std::uint32_t slot, Places& next) {
    const auto targets = surface_.links().targets(slot);
    next.reserve_more((targets.size() + 1) * most_marked);
    for (const std::uint32_t target : targets)
      marks_.mark_around<Shared, true>(target, surface_.row_of(target), next);
  }

  void wake(std::uint32_t slot) {
    candidates_.reserve_more(most_marked);
    marks_.mark_around<false, false>(slot, surface_.row_of(slot), candidates_);
    spread_to_targets<false>(slot, candidates_);
  }

  // Alarms of the next step are not needed after a change: what changed is a candidate then.
  void set_alarm(std::uint32_t slot, State state) {
    if constexpr (TimedBehaviour<B>) {
      const std::uint64_t step = behaviour_.alarm(state);
      if (step > step_ + 1) alarms_.set(slot, step - step_ - 1);
    }
  }
  void set_alarms() {
    if constexpr (TimedBehaviour<B>)
      for (const Row& row : surface_.rows())
        for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) set_alarm(slot, state_[slot]);
  }

  void unmark_unsettled() {
    for (const Row& row : surface_.rows())
      marks_.unmark_between(row.run_begin, row.run_end,
                            [&](std::uint32_t slot) { return !behaviour_.settled(state_[slot]); });
  }

  void consider_all() {
    const auto rows = surface_.rows();
    for (std::uint32_t r = 0; r < rows.size(); ++r)
      for (std::uint32_t slot = rows[r].run_begin; slot < rows[r].run_end; ++slot)
        if (may_change({r, slot}) && marks_.test_and_mark<false>(slot, 1u) != 0) candidates_.push({r, slot});
  }

  // In place, only cells that wait may be candidates: a change beside any other makes it one.
  bool may_change(const Place& place) const {
    if constexpr (StampedBehaviour<B>)
      return behaviour_.waits(around(place));
    else if constexpr (WakingBehaviour<B>)
      return !behaviour_.quiet(around(place));
    else
      return true;
  }

  const Surface& surface_;
  B behaviour_;
  GhostCarrier<B> carrier_;
  Field<State> state_;
  std::uint64_t seed_, step_;
  SlotMarks marks_;
  Alarms alarms_;
  Places candidates_, next_;
  Changes changes_;
  std::vector<Changes> task_changes_;
  std::vector<Places> task_next_;
  std::size_t tasks_ = 0;  // of the last step; 0: it was done by one thread
  Merges<State> merges_;   // what pairs made common in the last turn
};

}  // namespace verdigris
