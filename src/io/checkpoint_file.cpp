// Layout, all numbers little-endian, a text being its length (u32) and its bytes:
//   magic (8 bytes), format version (u32), bytes in the file (u64), step (u64)
//   count (u32) of identity pairs: what (text), value (text)
//   count (u32) of arrays: name (text), bytes a number (u32), numbers (u64)
//   the numbers of each array in turn
//   XXH3-128 of everything before, canonical (16 bytes)

#include "verdigris/io/checkpoint_file.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "binary_numbers.hpp"
#include "file_bytes.hpp"
#include "verdigris/io/replace_file.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

// Like PNG's: a transfer that changes line ends or drops the eighth bit breaks it.
constexpr std::string_view magic = "\x89VGC\r\n\x1a\n";
constexpr std::uint32_t format_version = 1;
constexpr std::size_t digest_size = 16;
constexpr const char* start_again = "take it from a backup, or start again without it";

using Digest = std::array<unsigned char, digest_size>;

class Checksum {
 public:
  Checksum() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
  void add(const void* data, std::size_t bytes) {
    if (bytes != 0) XXH3_128bits_update(state_.get(), data, bytes);
  }
  Digest digest() const {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
    Digest digest;
    std::copy(std::begin(canonical.digest), std::end(canonical.digest), digest.begin());
    return digest;
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

// Numbers of an array to little-endian or back; nothing to do on most machines.
void swap_on_big_endian(std::vector<std::byte>& bytes, std::size_t element_size) {
  if constexpr (std::endian::native == std::endian::big)
    for (std::size_t k = 0; k + element_size <= bytes.size(); k += element_size) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(k);
      std::reverse(first, first + static_cast<std::ptrdiff_t>(element_size));
    }
}

template <typename T>
void put(std::string& out, T value) {
  for (std::size_t k = 0; k < sizeof(T); ++k) out += static_cast<char>(value >> (8 * k) & 0xFF);
}

void put_text(std::string& out, const std::string& text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

// Everything before the numbers.
std::string head_of(const Checkpoint& checkpoint) {
  std::string rest;
  put(rest, checkpoint.state.step);
  put(rest, static_cast<std::uint32_t>(checkpoint.identity.size()));
  for (const auto& [what, value] : checkpoint.identity) {
    put_text(rest, what);
    put_text(rest, value);
  }
  put(rest, static_cast<std::uint32_t>(checkpoint.state.arrays.size()));
  std::uint64_t bytes = 0;
  for (const StateArray& array : checkpoint.state.arrays) {
    put_text(rest, array.name);
    put(rest, array.element_size);
    put(rest, std::uint64_t{array.bytes.size() / array.element_size});
    bytes += array.bytes.size();
  }
  std::string head(magic);
  put(head, format_version);
  put(head, std::uint64_t{head.size() + sizeof(std::uint64_t) + rest.size() + bytes + digest_size});
  return head + rest;
}

// A file read front to back; no length in it is believed beyond what the file still holds.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& file)
      : where_(file.string()), file_(open(file), &std::fclose), left_(std::filesystem::file_size(file)) {
    if (left_ < magic.size() || text_of(magic.size()) != magic)
      fail("this is no verdigris checkpoint", "name the checkpoint.vgc of a run");
  }

  std::uint64_t left() const { return left_; }

  template <typename T>
  T number() {
    std::array<char, sizeof(T)> bytes;
    take(bytes.data(), bytes.size());
    return io::load<T>(bytes.data(), false);
  }
  std::string text() { return text_of(number<std::uint32_t>()); }
  std::vector<std::byte> numbers(std::size_t element_size, std::uint64_t count) {
    if (count > left_ / element_size)
      fail("the file is damaged: an array in it is longer than the file", start_again);
    std::vector<std::byte> bytes(count * element_size);
    take(bytes.data(), bytes.size());
    swap_on_big_endian(bytes, element_size);
    return bytes;
  }
  void check_digest() {
    const Digest computed = checksum_.digest();
    Digest stored;
    if (left_ != stored.size()) fail("the file is damaged: its parts do not add up", start_again);
    take(stored.data(), stored.size());
    if (stored != computed) fail("the file is damaged: its checksum is not that of its content", start_again);
  }

  [[noreturn]] void fail(const std::string& problem, const char* remedy) const {
    throw InputError(where_, problem, remedy);
  }

 private:
  static std::FILE* open(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::not_found)
      throw InputError(file.string(), "there is no checkpoint",
                       "name the directory of a run that was stopped, or start without --resume");
    if (status.type() != std::filesystem::file_type::regular)
      throw InputError(file.string(), "this is no regular file", "name the checkpoint.vgc of a run");
    std::FILE* handle = std::fopen(file.c_str(), "rb");
    if (handle == nullptr)
      throw InputError(file.string(), fmt::format("cannot be opened ({})", std::strerror(errno)),
                       "check the permissions of the file");
    return handle;
  }

  void take(void* to, std::size_t bytes) {
    if (bytes > left_) fail("the file is damaged: it ends in the middle", start_again);
    if (bytes != 0 && std::fread(to, 1, bytes, file_.get()) != bytes)
      fail("reading stopped before the end of the file",
           "check the disk, and that nothing is writing the file");
    left_ -= bytes;
    checksum_.add(to, bytes);
  }
  std::string text_of(std::size_t length) {
    if (length > left_) fail("the file is damaged: a text in it is longer than the file", start_again);
    std::string text(length, '\0');
    take(text.data(), length);
    return text;
  }

  std::string where_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::uint64_t left_;
  Checksum checksum_;
};

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  ReplaceFile out(file);
  Checksum checksum;
  const auto write = [&](const void* data, std::size_t bytes) {
    out.write(data, bytes);
    checksum.add(data, bytes);
  };
  const std::string head = head_of(checkpoint);
  write(head.data(), head.size());
  for (const StateArray& array : checkpoint.state.arrays) {
    if constexpr (std::endian::native == std::endian::big) {
      std::vector<std::byte> swapped = array.bytes;
      swap_on_big_endian(swapped, array.element_size);
      write(swapped.data(), swapped.size());
    } else {
      write(array.bytes.data(), array.bytes.size());
    }
  }
  const Digest digest = checksum.digest();
  out.write(digest.data(), digest.size());
  out.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  Reader in(file);
  const auto version = in.number<std::uint32_t>();
  if (version != format_version)
    in.fail(fmt::format("it is of format version {}; this program reads version {}", version, format_version),
            "go on with the version of verdigris that wrote it, or start again without it");
  const auto before = magic.size() + sizeof(version) + in.left();
  const auto bytes = in.number<std::uint64_t>();
  if (bytes != before)
    in.fail(fmt::format("the file is damaged: it has {} bytes, of {} that were written", before, bytes),
            start_again);

  Checkpoint checkpoint;
  checkpoint.state.step = in.number<std::uint64_t>();
  for (auto pairs = in.number<std::uint32_t>(); pairs > 0; --pairs) {
    std::string what = in.text();
    checkpoint.identity.emplace_back(std::move(what), in.text());
  }
  std::vector<std::uint64_t> counts;
  for (auto arrays = in.number<std::uint32_t>(); arrays > 0; --arrays) {
    StateArray array{in.text(), in.number<std::uint32_t>(), {}};
    if (!std::has_single_bit(array.element_size) || array.element_size > 8)
      in.fail(fmt::format("the file is damaged: numbers of {} bytes", array.element_size), start_again);
    counts.push_back(in.number<std::uint64_t>());
    checkpoint.state.arrays.push_back(std::move(array));
  }
  for (std::size_t k = 0; k < counts.size(); ++k) {
    StateArray& array = checkpoint.state.arrays[k];
    array.bytes = in.numbers(array.element_size, counts[k]);
  }
  in.check_digest();
  return checkpoint;
}

}  // namespace verdigris
