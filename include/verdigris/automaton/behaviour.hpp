#pragma once
// What a behaviour is: a rule that makes the next state of a cell from its own and its eight neighbours'
// states.

#include <concepts>
#include <cstdint>
#include <vector>

#include "verdigris/automaton/random.hpp"

namespace verdigris {

/// A value for each slot of a surface; owned cells are kept, ghosts follow them.
template <typename T>
using Field = std::vector<T>;

/// A cell and its eight neighbours. Each pointer stands at the cell's own column of its row; -1 and +1 can be
/// read. "Above" is the grid row with the higher number.
template <typename State>
struct Neighbourhood {
  const State* below;
  const State* here;
  const State* above;

  const State& centre() const { return *here; }
  /// Sides: 0 left, 1 right, 2 below, 3 above.
  const State& side(int k) const { return k == 0 ? here[-1] : k == 1 ? here[1] : k == 2 ? *below : *above; }
  /// Corners: 0 below left, 1 below right, 2 above left, 3 above right.
  const State& corner(int k) const { return (k < 2 ? below : above)[(k & 1) == 0 ? -1 : 1]; }
};

/// A behaviour. `next` is pure: it reads the neighbourhood as it was, the random numbers of its cell and
/// step, and the behaviour's own parameters. `outside` is the state of what lies beyond a boundary.
template <typename B>
concept Behaviour = requires(const B& b, const Neighbourhood<typename B::State>& n,
                             const CellRandom& random) {
  { b.outside() } -> std::convertible_to<typename B::State>;
  { b.next(n, random) } -> std::same_as<typename B::State>;
};

/// A behaviour whose cells change only when something near them does: it can be run from a front.
///
/// `settled(s)`: a cell in state s never changes again. `waits(n)`: an unchanged cell may still change in a
/// later step though nothing around it does (its chance has not come yet); all other cells may be left alone
/// until a neighbour changes.
template <typename B>
concept FrontBehaviour = Behaviour<B> &&
    requires(const B& b, const Neighbourhood<typename B::State>& n, typename B::State s) {
  { b.settled(s) } -> std::same_as<bool>;
  { b.waits(n) } -> std::same_as<bool>;
};

/// A behaviour without random numbers or a clock: where nothing in a neighbourhood has changed in a step, the
/// cell will not change in the next. It can be run on active rows.
template <typename B>
concept RestingBehaviour = Behaviour<B> && B::rests;

/// A FrontBehaviour whose states carry the step they were made in, so that a step may be done in place:
/// `next` takes a neighbour that changed in this very step for what it was before, what changes is settled,
/// and a cell beside a changed one waits.
template <typename B>
concept StampedBehaviour = FrontBehaviour<B> && B::stamped;

/// A FrontBehaviour some of whose changes concern only cells that wait anyway. `wakes(before, after)`: after
/// this change the cell and its neighbours have to be looked at. `quiet(n)`: nothing around the cell has
/// changed since the start, and it will not change before something does; told from states alone, so that a
/// front finds where it stands after a restart. `still_waits(n, state)`: whether the cell waits, now that
/// `next` of this neighbourhood has made it `state`.
template <typename B>
concept WakingBehaviour = FrontBehaviour<B> &&
    requires(const B& b, const Neighbourhood<typename B::State>& n, typename B::State s) {
  { b.wakes(s, s) } -> std::same_as<bool>;
  { b.quiet(n) } -> std::same_as<bool>;
  { b.still_waits(n, s) } -> std::same_as<bool>;
};

/// A FrontBehaviour whose cells may lie still for a known time. `alarm(s)`: the step in which a cell in state
/// s has to be looked at again though nothing around it changes and it does not wait; 0: none.
template <typename B>
concept TimedBehaviour =
    FrontBehaviour<B> && !StampedBehaviour<B> && requires(const B& b, typename B::State s) {
  { b.alarm(s) } -> std::same_as<std::uint64_t>;
};

/// What can be run on active rows: rows know neither alarms nor changes that wake nobody.
template <typename B>
concept ActiveBehaviour = RestingBehaviour<B> ||
    (FrontBehaviour<B> && !WakingBehaviour<B> && !TimedBehaviour<B>);

/// A behaviour whose states hold directions. A ghost lies in another frame than its owner: it shows
/// `turned(state, eighths)`, the owner's state with its directions turned counter-clockwise by that many
/// times 45 degrees (0..7), the nearest to the angle between the frames.
template <typename B>
concept TurningBehaviour = Behaviour<B> && requires(const B& b, typename B::State s, unsigned eighths) {
  { b.turned(s, eighths) } -> std::same_as<typename B::State>;
};

/// A behaviour that can run on projected pairs: `merge(mine, theirs)` is what a cell becomes when the data of
/// a pair is made common. Several partners must give the same in any order, and one partner twice the same as
/// once.
template <typename B>
concept MergingBehaviour = Behaviour<B> && requires(const B& b, typename B::State s) {
  { b.merge(s, s) } -> std::same_as<typename B::State>;
};

/// A behaviour that wants to know when a step begins.
template <typename B>
concept SteppedBehaviour = requires(B& b, std::uint64_t step) {
  b.begin_step(step);
};

/// Where a stepper takes up a run that another one left, beside the states of the cells.
struct Restart {
  std::uint64_t step = 0;             ///< steps made so far
  std::vector<std::uint32_t> merged;  ///< projected links: slots that took a partner's state in the last
};

/// What one step did.
struct StepReport {
  std::uint64_t step = 0;     ///< number of the step just made, from 1
  std::uint64_t changed = 0;  ///< owned cells whose state differs from before
  std::uint64_t visited = 0;  ///< cells whose rule was evaluated
};

}  // namespace verdigris
