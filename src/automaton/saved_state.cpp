#include "verdigris/automaton/saved_state.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {
constexpr const char* remedy = "go on with the version that saved it, or start again";
}

const StateArray& SavedState::find(std::string_view name, std::size_t element_size) const {
  const auto array =
      std::find_if(arrays.begin(), arrays.end(), [&](const StateArray& a) { return a.name == name; });
  if (array == arrays.end())
    throw InputError("saved state", fmt::format("there is no array '{}' in it", name), remedy);
  if (array->element_size != element_size || array->bytes.size() % element_size != 0)
    throw InputError(
        "saved state",
        fmt::format("its array '{}' has {} bytes a number, not {}", name, array->element_size, element_size),
        remedy);
  return *array;
}

std::size_t evolving_count(const Surface& surface) {
  std::size_t cells = 0;
  for (const Row& row : surface.rows()) cells += row.run_end - row.run_begin;
  return cells;
}

void check_cells(const StateArray& array, const Surface& surface) {
  const std::size_t saved = array.bytes.size() / array.element_size, cells = evolving_count(surface);
  if (saved != cells)
    throw InputError("saved state",
                     fmt::format("its array '{}' is of {} cells, not {}", array.name, saved, cells), remedy);
}

Restart restart_of(const Surface& surface, const SavedState& saved) {
  Restart restart{saved.step, restore_numbers<std::uint32_t>(saved, "merged")};
  for (const std::uint32_t slot : restart.merged)
    if (slot >= surface.slot_count())
      throw InputError("saved state", fmt::format("it names slot {} of {}", slot, surface.slot_count()),
                       remedy);
  return restart;
}

}  // namespace verdigris
