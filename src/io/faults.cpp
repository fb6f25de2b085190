#include "faults.hpp"

#include <fmt/format.h>

#include "file_bytes.hpp"

namespace verdigris::io {

std::size_t line_of(std::string_view text, std::size_t offset) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < offset && i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n' || c == '\v' || (c == '\r' && !(i + 1 < text.size() && text[i + 1] == '\n'))) ++line;
  }
  return line;
}

std::string in_quotes(std::string_view found) {
  constexpr std::size_t longest = 32;
  std::string text = "'";
  for (const char c : found.substr(0, longest)) text += c >= 32 && c < 127 ? c : '?';
  return text + (found.size() > longest ? "...'" : "'");
}

void Faults::add(std::size_t offset, std::string_view problem, const char* remedy) {
  if (known(remedy) || any()) return;
  remedy_ = remedy;
  offset_ = offset;
  alike_ = 1;
  problem_ = problem;
}

InputError Faults::error() const {
  const std::string where =
      lines_ ? fmt::format("{}:{}", shown(file_), line_of(text_, offset_)) : shown(file_);
  std::string problem = problem_;
  if (!lines_) problem += fmt::format(" (at byte {})", offset_);
  if (alike_ > 1) problem += fmt::format("; {} like this in all", alike_);
  return InputError(where, problem, remedy_);
}

void Faults::check() const {
  if (any()) throw error();
}

void Faults::stop(std::size_t offset, std::string_view problem, const char* remedy) {
  add(offset, problem, remedy);
  throw error();
}

}  // namespace verdigris::io
