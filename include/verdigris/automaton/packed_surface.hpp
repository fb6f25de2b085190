#pragma once
// A surface for one-bit behaviours: 64 cells to a word, ghosts gathered as streams of bits.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The cells of a surface as bits. Made once, then const.
///
/// Each patch is a set of *word columns*: bit b of word column k is grid column `origin + 64 k + b`. The
/// words of one word column stand one after the other by grid row, so the cell above is the same bit of the
/// next word, and eight rows are one wide vector. Triangles narrow towards C: a word column ends with the
/// last row that reaches into it.
///
/// Only owned cells have their bit in the state; those of ghosts are gathered before a step from
/// `ghost_sources`, in the order of the patch's words, and laid around the owned ones. Which bits of a word
/// are which takes four bytes, not two words: large surfaces are read at the speed of memory.
class PackedSurface {
 public:
  /// Works on surfaces with unfolded links; throws std::invalid_argument for others. Cells of up to 2^32 bits
  /// in all.
  explicit PackedSurface(const Surface& surface);

  /// The bits of one word: owned [owned_begin, owned_end), ghosts the others of [begin, end); 0 to 64.
  struct Bits {
    std::uint8_t begin, end, owned_begin, owned_end;

    std::uint64_t owned() const { return between(owned_begin, owned_end); }
    std::uint64_t ghosts() const { return between(begin, end) & ~owned(); }

   private:
    static std::uint64_t between(unsigned from, unsigned to) { return low(to) & ~low(from); }
    static std::uint64_t low(unsigned count) {
#ifdef __BMI2__
      return __builtin_ia32_bzhi_di(~std::uint64_t{0}, count);
#else
      return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
#endif
    }
  };

  struct Patch {
    std::uint32_t word_begin;    ///< first of its words, in all word arrays
    std::uint32_t ghost_begin;   ///< first of its ghosts in ghost_sources(), a multiple of 16
    std::uint32_t column_begin;  ///< first of its word columns in column_rows()
    std::int32_t origin;         ///< grid column of bit 0 of word column 0
  };

  std::size_t patch_count() const {
    return patches_.size() - 1;
  }
  const Patch& patch(std::size_t p) const {
    return patches_[p];
  }  ///< patch_count() gives the ends
  /// Words in each word column of a patch: grid rows -1 to count - 2.
  std::span<const std::uint32_t> column_rows(std::size_t p) const {
    return {column_rows_.data() + patches_[p].column_begin,
            column_rows_.data() + patches_[p + 1].column_begin};
  }
  std::size_t word_count() const {
    return patches_.back().word_begin;
  }
  const Bits* bits() const {
    return bits_.data();
  }  ///< [word], eight more at the end
  /// [ghost] bit of the state that it copies; bit 0 is always empty: what lies beyond a boundary.
  const std::uint32_t* ghost_sources() const {
    return ghost_sources_.data();
  }
  std::size_t owned_count() const {
    return owned_count_;
  }
  std::size_t largest_patch_words() const {
    return largest_patch_words_;
  }
  std::size_t bytes() const;

  /// Bit of an owned slot of the surface it was made from.
  std::uint32_t bit_of(const Surface& surface, std::uint32_t slot) const;

 private:
  std::uint32_t bit_at(std::uint32_t patch, std::uint32_t row_index, std::int32_t column) const;

  std::vector<Patch> patches_;  // one more at the end
  std::vector<std::uint32_t> column_rows_;
  std::vector<Bits> bits_;  // [word], eight more at the end
  std::vector<std::uint32_t> ghost_sources_;
  std::size_t owned_count_ = 0, largest_patch_words_ = 0;
};

}  // namespace verdigris
