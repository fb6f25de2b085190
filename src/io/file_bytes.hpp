#pragma once
// A whole file in memory, read once.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace verdigris::io {

/// The bytes of a file. Writable, so that a reader may blank what it does not want to see.
class FileBytes {
 public:
  explicit FileBytes(std::size_t size) : data_(std::make_unique_for_overwrite<char[]>(size)), size_(size) {}

  char* data() { return data_.get(); }
  std::size_t size() const { return size_; }
  std::string_view view() const { return {data_.get(), size_}; }

 private:
  std::unique_ptr<char[]> data_;
  std::size_t size_;
};

/// Reads a regular file. Throws InputError when it is missing, empty, unreadable, a directory, a pipe or a
/// device (all of which opening could block on, or answer with nonsense).
FileBytes read_file(const std::filesystem::path& file);

/// Blanks a UTF-8 byte order mark.
void blank_byte_order_mark(FileBytes& bytes);

/// Makes ready what has to be text: blanks a UTF-8 byte order mark; throws InputError when there are NUL
/// bytes.
void prepare_text(FileBytes& bytes, const std::filesystem::path& file);

/// The file's name as messages show it.
std::string shown(const std::filesystem::path& file);

}  // namespace verdigris::io
