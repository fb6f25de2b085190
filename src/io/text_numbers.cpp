#include "text_numbers.hpp"

#include <fmt/format.h>

namespace verdigris::io {

void fault_number(Faults& faults, std::size_t offset, std::string_view word, NumberState state,
                  const char* what) {
  if (word.empty()) {
    if (!faults.known(remedy_short_line))
      faults.add(offset, fmt::format("the line ends where a {} should be", what), remedy_short_line);
    return;
  }
  switch (state) {
    case NumberState::good:
      break;
    case NumberState::not_finite:
      if (!faults.known(remedy_not_finite))
        faults.add(offset, fmt::format("the {} is {}, which is not finite", what, in_quotes(word)),
                   remedy_not_finite);
      break;
    case NumberState::too_large:
      if (!faults.known(remedy_too_large))
        faults.add(offset, fmt::format("the {} {} is too large", what, in_quotes(word)), remedy_too_large);
      break;
    case NumberState::malformed:
      if (!faults.known(remedy_malformed)) {
        const char* why = word.find(',') != std::string_view::npos ? " (a decimal comma?)" : "";
        faults.add(offset, fmt::format("the {} {} is not a number{}", what, in_quotes(word), why),
                   remedy_malformed);
      }
      break;
  }
}

}  // namespace verdigris::io
