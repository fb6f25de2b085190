#pragma once
// The state of a running simulation as plain arrays: what a checkpoint keeps of it.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A named array of numbers in the byte order of the machine.
struct StateArray {
  std::string name;
  std::uint32_t element_size = 1;  ///< bytes of one number: 1, 2, 4 or 8
  std::vector<std::byte> bytes;
};

/// Where a simulation stands. With the setup and the parameters it was made with, all it takes to go on from
/// there.
struct SavedState {
  std::uint64_t step = 0;  ///< steps made so far
  std::vector<StateArray> arrays;

  /// The array `name`. Throws InputError when there is none, or `element_size` is not its own.
  const StateArray& find(std::string_view name, std::size_t element_size) const;
};

/// Numbers as an array of a saved state.
template <typename T>
StateArray save_numbers(std::string name, std::span<const T> values) {
  static_assert(std::is_arithmetic_v<T>);
  const auto bytes = std::as_bytes(values);
  return {std::move(name), sizeof(T), std::vector<std::byte>(bytes.begin(), bytes.end())};
}

/// The numbers of array `name` again. Throws InputError as SavedState::find does.
template <typename T>
std::vector<T> restore_numbers(const SavedState& saved, std::string_view name) {
  const StateArray& array = saved.find(name, sizeof(T));
  std::vector<T> values(array.bytes.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), array.bytes.data(), values.size() * sizeof(T));
  return values;
}

/// How many cells of a surface evolve: what a saved field holds; ghosts and guards can be made anew.
std::size_t evolving_count(const Surface& surface);

/// Throws InputError unless `array` holds a state for each evolving cell of `surface`.
void check_cells(const StateArray& array, const Surface& surface);

/// The states of the evolving cells in row order.
template <typename State>
StateArray save_cells(const Surface& surface, const Field<State>& state, std::string name = "cells") {
  static_assert(std::is_arithmetic_v<State> || std::is_enum_v<State>);
  StateArray array{std::move(name), sizeof(State), {}};
  array.bytes.reserve(evolving_count(surface) * sizeof(State));
  for (const Row& row : surface.rows()) {
    const auto run = std::as_bytes(std::span(state).subspan(row.run_begin, row.run_end - row.run_begin));
    array.bytes.insert(array.bytes.end(), run.begin(), run.end());
  }
  return array;
}

/// A field with the evolving cells as save_cells saw them, `elsewhere` in all other slots. Throws InputError
/// when the array is not there or not of this surface.
template <typename State>
Field<State> restore_cells(const Surface& surface, const SavedState& saved, State elsewhere,
                           std::string_view name = "cells") {
  const StateArray& array = saved.find(name, sizeof(State));
  check_cells(array, surface);
  Field<State> state = large_vector(surface.slot_count(), elsewhere);
  const std::byte* from = array.bytes.data();
  for (const Row& row : surface.rows()) {
    const std::size_t bytes = (row.run_end - row.run_begin) * sizeof(State);
    if (bytes != 0) std::memcpy(state.data() + row.run_begin, from, bytes);
    from += bytes;
  }
  return state;
}

/// A stepper as it stands: its cells, and what its Restart holds.
template <typename Stepper>
SavedState save_stepper(const Surface& surface, const Stepper& stepper) {
  const Restart restart = stepper.restart();
  return {restart.step,
          {save_cells(surface, stepper.state()),
           save_numbers("merged", std::span<const std::uint32_t>(restart.merged))}};
}

/// The Restart of a stepper that save_stepper saved. Throws InputError when it is not of this surface.
Restart restart_of(const Surface& surface, const SavedState& saved);

}  // namespace verdigris
