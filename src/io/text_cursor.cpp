#include "text_cursor.hpp"

#include <cmath>

namespace verdigris::io {

namespace {

/// Whether a number that did not fit is too small (then it is 0) rather than too large.
bool is_underflow(std::string_view word) {
  const std::size_t exponent = word.find_first_of("eE");
  if (exponent != std::string_view::npos) return exponent + 1 < word.size() && word[exponent + 1] == '-';
  return word.find_first_of("123456789") > word.find('.');
}

}  // namespace

Number parse_number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);  // from_chars knows no plus
  Number number;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number.value);
  if (stop != end || error == std::errc::invalid_argument) {
    number.state = NumberState::malformed;
    // nan(...) and the spellings of other languages' runtimes: 1.#IND, 1.#QNAN, -1.#INF
    if (word.find("#I") != std::string_view::npos || word.find("#Q") != std::string_view::npos)
      number.state = NumberState::not_finite;
  } else if (error == std::errc::result_out_of_range) {
    number.value = 0.0;
    if (!is_underflow(word)) number.state = NumberState::too_large;
  } else if (!std::isfinite(number.value)) {
    number.state = NumberState::not_finite;
  } else if (std::abs(number.value) > largest_number) {
    number.state = NumberState::too_large;
  }
  if (number.state != NumberState::good) number.value = 0.0;
  return number;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  std::int64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error != std::errc()) return std::nullopt;
  return value;
}

}  // namespace verdigris::io
