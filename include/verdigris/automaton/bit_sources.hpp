#pragma once
// Where the ghosts of packed cells take their bits from, and how they are gathered into a stream.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace verdigris {

/// The sources of the ghosts of all patches, each the number of a bit of the state. Patch by patch, then
/// const.
///
/// The ghosts of a patch copy cells of a few patches around it. Where their sources lie in at most 16
/// *windows* of 4096 bits, two bytes tell window and bit; else a source takes four.
class BitSources {
 public:
  BitSources() : patches_(1, Patch{}) {}

  /// The ghosts of one more patch, in the order in which they come out of gather(). The stream goes on at a
  /// multiple of 16 bits.
  void add_patch(std::span<const std::uint32_t> sources);

  /// No more patches come: gives back the room for them.
  void settle();

  std::size_t patch_count() const { return patches_.size() - 1; }
  /// Bit of the stream where the ghosts of a patch begin; patch_count() gives the end.
  std::uint32_t begin(std::size_t patch) const { return patches_[patch].ghost_begin; }
  /// Copies the bits of all ghosts of some patches from `state` into `stream`. Other patches may be gathered
  /// at the same time.
  void gather(std::size_t first_patch, std::size_t last_patch, const std::uint64_t* state,
              std::uint64_t* stream) const;
  std::size_t bytes() const;

 private:
  struct Patch {
    std::uint32_t ghost_begin, source_begin, window_begin;
  };
  static constexpr unsigned window_bits = 12;
  static constexpr std::size_t most_windows = 16;

  bool add_near(std::span<const std::uint32_t> sources);

  std::vector<Patch> patches_;          // one more at the end; where a patch has no windows it is far
  std::vector<std::uint32_t> windows_;  // first bit of each
  std::vector<std::uint16_t> near_;     // window, bit in it
  std::vector<std::uint32_t> far_;
};

}  // namespace verdigris
