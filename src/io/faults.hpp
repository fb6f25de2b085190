#pragma once
// What is wrong with a file: the first fault said in full, those like it counted.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "verdigris/base/error.hpp"

namespace verdigris::io {

/// The one-based line that holds byte `offset`. LF, CR LF and CR all end a line; so does '\v', which stands
/// where a reader has joined continued lines.
std::size_t line_of(std::string_view text, std::size_t offset);

/// A short, printable form of something found in a file, for messages.
std::string in_quotes(std::string_view found);

/// Collects faults while a text or binary file is read, so that one message can say how many there are.
/// Lines are counted only when a fault is found, never on the fast path.
class Faults {
 public:
  /// `text` must outlive this object. With `lines` places are "file:line", else "file" and a byte offset.
  Faults(std::filesystem::path file, std::string_view text, bool lines)
      : file_(std::move(file)), text_(text), lines_(lines) {}

  /// Notes a fault at byte `offset`. Faults are alike when their remedy is the same string literal.
  void add(std::size_t offset, std::string_view problem, const char* remedy);

  /// True for a fault that only needs counting: its text need not be made again.
  bool known(const char* remedy) {
    if (remedy_ != remedy) return false;
    ++alike_;
    return true;
  }

  bool any() const { return remedy_ != nullptr; }

  /// Throws what was noted, if anything.
  void check() const;

  /// Notes a fault after which reading cannot go on, and throws the first one noted.
  [[noreturn]] void stop(std::size_t offset, std::string_view problem, const char* remedy);

  std::string_view text() const { return text_; }
  const std::filesystem::path& file() const { return file_; }

 private:
  InputError error() const;

  std::filesystem::path file_;
  std::string_view text_;
  bool lines_;
  const char* remedy_ = nullptr;
  std::size_t offset_ = 0, alike_ = 0;
  std::string problem_;
};

}  // namespace verdigris::io
