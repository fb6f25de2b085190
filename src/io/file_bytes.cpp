#include "file_bytes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "verdigris/base/error.hpp"

namespace verdigris::io {

namespace fs = std::filesystem;

std::string shown(const fs::path& file) {
  return file.string();
}

void blank_byte_order_mark(FileBytes& bytes) {
  if (bytes.view().starts_with("\xEF\xBB\xBF")) std::fill_n(bytes.data(), 3, ' ');
}

void prepare_text(FileBytes& bytes, const fs::path& file) {
  if (const void* nul = std::memchr(bytes.data(), 0, bytes.size()))
    throw InputError(shown(file),
                     fmt::format("this is not text: there is a zero at byte {}",
                                 static_cast<const char*>(nul) - bytes.data()),
                     "check that the file is what its extension says, and was not damaged on the way");
  blank_byte_order_mark(bytes);
}

FileBytes read_file(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(shown(file), "there is no such file", "check the path and its spelling");
  if (status.type() == fs::file_type::directory)
    throw InputError(shown(file), "this is a directory", "name the model file inside it");
  if (status.type() == fs::file_type::none)
    throw InputError(shown(file), fmt::format("cannot be looked at ({})", error.message()),
                     "check the permissions of the file and its directory");
  if (status.type() != fs::file_type::regular)
    throw InputError(shown(file), "this is a pipe, socket or device, not a regular file",
                     "save the data to a file first");

  const std::uintmax_t size = fs::file_size(file, error);
  if (error)
    throw InputError(shown(file), fmt::format("its size cannot be found ({})", error.message()),
                     "check that the disk is readable");
  if (size == 0) throw InputError(shown(file), "the file is empty", "export or download it again");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> handle(std::fopen(file.c_str(), "rb"), &std::fclose);
  if (!handle)
    throw InputError(shown(file), fmt::format("cannot be opened ({})", std::strerror(errno)),
                     "check the permissions of the file");
  FileBytes bytes(size);
  if (std::fread(bytes.data(), 1, size, handle.get()) != size)
    throw InputError(shown(file), "reading stopped before the end of the file",
                     "check the disk, and that nothing is still writing the file");
  return bytes;
}

}  // namespace verdigris::io
