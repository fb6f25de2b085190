#pragma once
// Which bits of packed cells other patches repeat as ghosts, and how they are gathered into a stream.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace verdigris {

/// The bits that each patch sends to others, in the order in which those lay them around their own cells:
/// gathered while the patch is at hand, so that a step meets every patch once. Patch by patch, then const.
///
/// A bit is told by its number within the patch, of 12 bits where all fit, else of 16 or 32.
class SentBits {
 public:
  SentBits() : patches_(1, Patch{}) {}

  /// What one more patch sends. Its stream begins at a multiple of 16 bits.
  void add_patch(std::span<const std::uint32_t> bits);

  /// No more patches come. Before any gather().
  void settle();

  std::size_t patch_count() const { return patches_.size() - 1; }
  /// Bit of the stream where that of a patch begins; patch_count() gives the end.
  std::uint32_t begin(std::size_t patch) const { return patches_[patch].stream_begin; }
  /// Copies what a patch sends into `stream`, from the words of its state; the bits up to the next multiple
  /// of 16 may become anything. Other patches may be gathered at the same time.
  void gather(std::size_t patch, const std::uint64_t* words, std::uint64_t* stream) const;
  std::size_t bytes() const;

 private:
  struct Patch {
    std::uint32_t stream_begin;
    std::uint32_t from;  // its numbers are from byte 8 * from on, 16 after 16 of one width
  };

  std::vector<Patch> patches_;  // one more at the end
  std::vector<std::uint8_t> numbers_;
};

}  // namespace verdigris
