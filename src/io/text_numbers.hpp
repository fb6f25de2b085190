#pragma once
// Numbers of text formats, with what to say when they are none.

#include <cstdint>
#include <string_view>

#include "faults.hpp"
#include "text_cursor.hpp"

namespace verdigris::io {

inline constexpr char remedy_not_finite[] =
    "delete or repair this vertex in the program that made the model (often a face of no area), and export "
    "again";
inline constexpr char remedy_too_large[] = "scale the model to ordinary sizes (below 1e60) and export again";
inline constexpr char remedy_malformed[] =
    "write numbers like -1.5 or 2e-3, with a decimal point whatever the language settings, and export again";
inline constexpr char remedy_short_line[] =
    "the file may have been cut off or edited: export or download it again";
inline constexpr char remedy_index[] =
    "the file may have been cut off or its vertices removed: export or download it again";
inline constexpr char remedy_corners[] =
    "remove faces of fewer than three corners (loose edges) and export again";
inline constexpr char remedy_no_faces[] =
    "export the model as a polygon mesh: point clouds, curves and free-form surfaces have to be meshed first";
inline constexpr char remedy_too_many[] =
    "split the model, or simplify it, to fewer than a thousand million triangles";

/// Says what a word that is not a usable number is. Does nothing for one that is.
void fault_number(Faults& faults, std::size_t offset, std::string_view word, NumberState state,
                  const char* what);

/// `word`, which stands at `offset`, as a number; 0 with a fault noted when it is none. `what` names it in
/// messages.
inline double number_at(std::string_view word, std::size_t offset, Faults& faults, const char* what) {
  const Number number = parse_number(word);
  if (number.state != NumberState::good) [[unlikely]]
    fault_number(faults, offset, word, number.state, what);
  return number.value;
}

/// The next word of the line as a number.
inline double next_number(TextCursor& cursor, Faults& faults, const char* what) {
  const std::string_view word = cursor.word();
  return number_at(word, cursor.word_offset(), faults, what);
}

}  // namespace verdigris::io
