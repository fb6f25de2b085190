#pragma once
// Writing a file so that it is either whole or not there: aside first, renamed when done.

#include <cstdio>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace verdigris {

/// A file being written beside its target. `commit` puts it in place; without it the destructor removes it.
/// Every failure throws InputError naming the target and the system's reason.
class ReplaceFile {
 public:
  explicit ReplaceFile(std::filesystem::path target);
  ReplaceFile(const ReplaceFile&) = delete;
  ReplaceFile& operator=(const ReplaceFile&) = delete;
  ~ReplaceFile();

  void write(std::string_view text);
  void write(const void* data, std::size_t bytes);
  std::FILE* stream() const { return file_; }
  /// The file aside, for another program to write.
  const std::filesystem::path& aside() const { return aside_; }
  /// Flushes to disk and renames over the target.
  void commit();

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path target_, aside_;
  std::FILE* file_ = nullptr;
};

/// Removes what processes that ended before their commit left beside `target`.
void remove_abandoned(const std::filesystem::path& target);

/// Makes `directory` and its parents. Throws InputError when that cannot be done.
void make_directory(const std::filesystem::path& directory);

}  // namespace verdigris
