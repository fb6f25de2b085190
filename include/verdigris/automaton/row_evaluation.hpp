#pragma once
// The next states of one row of cells: many at a time where the behaviour can, else one after the other.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The states around an evolving slot of `row`, which stands in Surface::rows(); `state` is a field [slot].
/// Offsets wrap around: pointers are formed from 32-bit slots.
template <typename State>
[[gnu::always_inline]] inline Neighbourhood<State> neighbourhood_of(const Row* row, std::uint32_t slot,
                                                                    const State* state) {
  const std::uint32_t column = slot - row->base;
  return {state + static_cast<std::uint32_t>(row[-1].base + column), state + slot,
          state + static_cast<std::uint32_t>(row[1].base + column)};
}

/// A behaviour that makes the next states of `lanes` cells side by side at once: next_lanes<lanes>(below,
/// here, above, out), the pointers of a Neighbourhood at the first of them. Without random numbers. Loops of
/// a fixed length that compilers make vectors of; the same states as `next`, cell by cell. Some of them may
/// be no cells that evolve, with any states around them: what is made of those is not used.
template <typename B>
concept LaneBehaviour = Behaviour<B> &&
    requires(const B& b, const typename B::State* in, typename B::State* out) {
  b.template next_lanes<8>(in, in, in, out);
};

namespace detail {

/// A row of less than `lanes` cells, and at least half as many, as one vector. What it makes of the cells
/// behind the row comes to nothing.
template <std::size_t lanes, LaneBehaviour B>
std::uint64_t evaluate_short_row(const B& behaviour, const Neighbourhood<typename B::State>& n,
                                 typename B::State* next, std::size_t count) {
  typename B::State made[lanes];
  behaviour.template next_lanes<lanes>(n.below, n.here, n.above, made);
  std::uint8_t changed = 0;
  for (std::size_t k = 0; k < lanes; ++k)
    changed = static_cast<std::uint8_t>(changed + ((k < count) & (made[k] != n.here[k])));
  // Its two ends, which overlap: both are of a fixed length.
  std::copy_n(made, lanes / 2, next);
  std::copy_n(made + count - lanes / 2, lanes / 2, next + count - lanes / 2);
  return changed;
}

/// One vector of a long row, of which the first `done` cells are done and not counted again.
template <std::size_t lanes, LaneBehaviour B>
std::uint64_t evaluate_lanes(const B& behaviour, const Neighbourhood<typename B::State>& n,
                             typename B::State* next, std::size_t done) {
  behaviour.template next_lanes<lanes>(n.below, n.here, n.above, next);
  std::uint8_t changed = 0;
  for (std::size_t k = 0; k < lanes; ++k)
    changed = static_cast<std::uint8_t>(changed + ((k >= done) & (next[k] != n.here[k])));
  return changed;
}

/// Vector after vector, the last one reaching back over cells already done.
template <std::size_t lanes, LaneBehaviour B>
std::uint64_t evaluate_long_row(const B& behaviour, const Neighbourhood<typename B::State>& n,
                                typename B::State* next, std::size_t count) {
  std::uint64_t changed = 0;
  const auto at = [&](std::size_t k) {
    return Neighbourhood<typename B::State>{n.below + k, n.here + k, n.above + k};
  };
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes) changed += evaluate_lanes<lanes>(behaviour, at(k), next + k, 0);
  if (k < count)
    changed += evaluate_lanes<lanes>(behaviour, at(count - lanes), next + count - lanes, lanes - (count - k));
  return changed;
}

}  // namespace detail

/// Writes the next states of the evolving cells of row `r` into `next`, both fields [slot]; returns how many
/// differ from before.
template <Behaviour B>
std::uint64_t evaluate_row(const Surface& surface, std::uint32_t r, const B& behaviour,
                           const typename B::State* state, typename B::State* next, std::uint64_t seed,
                           std::uint64_t step) {
  using State = typename B::State;
  const Row* row = surface.rows().data() + r;
  const std::uint32_t begin = row->run_begin;
  const std::size_t count = row->run_end - begin;
  // Found once: what is written may look like rows to a compiler.
  const auto n = neighbourhood_of(row, begin, state);
  State* const out = next + begin;
  if constexpr (LaneBehaviour<B>) {
    if (count >= 64) return detail::evaluate_long_row<64>(behaviour, n, out, count);
    // A vector and the cell beside it must not reach over the end of the field.
    if (static_cast<std::size_t>(n.above - state) + 64 < surface.slot_count()) {
      if (count >= 32) return detail::evaluate_short_row<64>(behaviour, n, out, count);
      if (count >= 16) return detail::evaluate_short_row<32>(behaviour, n, out, count);
      if (count >= 8) return detail::evaluate_short_row<16>(behaviour, n, out, count);
      if (count >= 4) return detail::evaluate_short_row<8>(behaviour, n, out, count);
    }
  }
  std::uint64_t changed = 0;
  for (std::size_t k = 0; k < count; ++k) {
    out[k] = behaviour.next(Neighbourhood<State>{n.below + k, n.here + k, n.above + k},
                            CellRandom(seed, step, begin + static_cast<std::uint32_t>(k)));
    changed += out[k] != n.here[k];
  }
  return changed;
}

}  // namespace verdigris
