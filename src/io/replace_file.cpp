#include "verdigris/io/replace_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {
constexpr const char* remedy = "choose a directory that exists, has space and can be written";
}

ReplaceFile::ReplaceFile(std::filesystem::path target) : target_(std::move(target)) {
  // A rename would put a file in the place of a device, and fail over a directory after all the work.
  std::error_code ignored;
  const auto kind = std::filesystem::status(target_, ignored).type();
  if (kind != std::filesystem::file_type::not_found && kind != std::filesystem::file_type::regular &&
      kind != std::filesystem::file_type::none)
    throw InputError(target_.string(), "is there already, and is no file that can be replaced",
                     "choose another name");
  // The process id keeps two runs into one directory apart.
  aside_ = target_;
  aside_ += fmt::format(".{}.part", ::getpid());
  file_ = std::fopen(aside_.c_str(), "wb");
  if (file_ == nullptr) fail("cannot be written");
  std::setvbuf(file_, nullptr, _IOFBF, std::size_t{1} << 20);
}

ReplaceFile::~ReplaceFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  ::unlink(aside_.c_str());
}

void ReplaceFile::write(std::string_view text) {
  write(text.data(), text.size());
}

void ReplaceFile::write(const void* data, std::size_t bytes) {
  if (bytes != 0 && std::fwrite(data, 1, bytes, file_) != bytes) fail("could not be written in full");
}

void ReplaceFile::commit() {
  if (std::fflush(file_) != 0 || std::ferror(file_) != 0 || ::fsync(::fileno(file_)) != 0)
    fail("could not be written in full");
  std::FILE* file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0 || std::rename(aside_.c_str(), target_.c_str()) != 0) {
    const int reason = errno;
    ::unlink(aside_.c_str());
    errno = reason;
    fail("could not be put in place");
  }
}

void ReplaceFile::fail(const char* what) const {
  throw InputError(target_.string(), fmt::format("{}: {}", what, std::strerror(errno)), remedy);
}

void remove_abandoned(const std::filesystem::path& target) {
  const std::string prefix = target.filename().string() + '.', suffix = ".part";
  const std::filesystem::path directory = target.has_parent_path() ? target.parent_path() : ".";
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() <= prefix.size() + suffix.size())
      continue;
    ::pid_t process = 0;
    const char* const last = name.data() + name.size() - suffix.size();
    const auto [rest, wrong] = std::from_chars(name.data() + prefix.size(), last, process);
    if (wrong == std::errc() && rest == last && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH)
      ::unlink(entry->path().c_str());
  }
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error || !std::filesystem::is_directory(directory))
    throw InputError(directory.string(),
                     fmt::format("is no directory and cannot be made one: {}",
                                 error ? error.message() : std::string("a file of that name exists")),
                     "choose another directory with --out");
}

}  // namespace verdigris
