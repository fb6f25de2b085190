#pragma once
// Words and numbers out of a text in memory: no locale, no copies, no streams.

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>

namespace verdigris::io {

/// What a word turned out to be when it was read as a number.
enum class NumberState : std::uint8_t { good, malformed, not_finite, too_large };

/// Coordinates beyond this would overflow where areas and volumes are squared.
constexpr double largest_number = 1e60;

struct Number {
  double value = 0.0;
  NumberState state = NumberState::good;
};

/// Reads all of `word` as a decimal number; never what a locale thinks is one.
Number parse_number(std::string_view word);

/// Reads all of `word` as a whole number; nothing when it is not one or does not fit.
std::optional<std::int64_t> parse_integer(std::string_view word);

/// Walks over a text line by line, and over each line word by word.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  /// The next word of this line, or an empty one at its end. `#` starts a comment that lasts to the line's
  /// end.
  std::string_view word() {
    skip_blanks();
    if (at_ < text_.size() && text_[at_] == '#') skip_rest();
    const std::size_t from = at_;
    while (at_ < text_.size() && !ends_word(text_[at_])) ++at_;
    word_start_ = from;
    return text_.substr(from, at_ - from);
  }

  /// The next word of any line, or an empty one at the end of the text.
  std::string_view word_on_any_line() {
    for (;;) {
      const std::string_view found = word();
      if (!found.empty() || at_end()) return found;
      next_line();
    }
  }

  void skip_rest() {
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  }

  /// Goes to the start of the next line: past LF, CR LF or CR.
  void next_line() {
    skip_rest();
    if (at_ < text_.size())
      at_ += text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n' ? 2 : 1;
  }

  bool at_end() const { return at_ >= text_.size(); }
  std::size_t offset() const { return at_; }
  /// Byte offset of the word given out last.
  std::size_t word_offset() const { return word_start_; }

 private:
  // '\v' stands for a line end that a continuation has joined.
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool ends_word(char c) { return is_blank(c) || c == '\n' || c == '\r'; }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, word_start_ = 0;
};

}  // namespace verdigris::io
