#pragma once
// A surface for one-bit behaviours: 64 cells to a word, ghosts sent from patch to patch as a stream of bits.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/automaton/sent_bits.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The cells of a surface as bits. Made once, then const.
///
/// Each patch is a set of *word columns*: bit b of word column k is grid column `origin + 64 k + b`. The
/// words of one word column stand one after the other by grid row, so the cell above is the same bit of the
/// next word, and eight rows are one wide vector. Triangles narrow towards C: a word column ends with the
/// last row that reaches into it.
///
/// Only owned cells have their bit in the state. After a step each patch puts the bits that others repeat as
/// ghosts into a stream; see `sent`. For the next one a patch is copied and its ghosts, of the stream, are
/// laid around the owned cells: eight words at a time from a `Group`, the few that this does not fit from a
/// `LooseRun`. The copy of a word column begins with seven words of no meaning, so that word 1, the first in
/// which cells evolve, stands where a vector begins; see `Column::pitch`.
class PackedSurface {
 public:
  /// Works on surfaces with unfolded links; throws std::invalid_argument for others. Cells of up to 2^32 bits
  /// in all.
  explicit PackedSurface(const Surface& surface);

  /// A word column: words 0 to rows - 1, grid rows -1 to rows - 2. In the first and the last nothing is
  /// owned.
  struct Column {
    std::uint32_t word_begin;  ///< first of its words in the state
    std::uint32_t rows;
    std::uint32_t inside;  ///< so many groups from the first on are owned from end to end, without a Group

    /// Eights of words from word 1 on that hold all owned ones.
    std::uint32_t groups() const { return rows < 3 ? 0 : (rows + 5) / 8; }
    /// Words of its copy: word w stands at 7 + w.
    std::uint32_t pitch() const { return 8 * (groups() + 2); }
  };

  /// The bits of eight words: [owned_begin, owned_end) is owned, ghosts lie on both sides. Those on the left
  /// are among the 64 bits of the stream from byte `left_byte` on; turned left by `left_turn` they are in
  /// their place. So are those on the right. Bits that no cell has may become anything, and so may ghosts
  /// that a loose run brings.
  struct Group {
    std::uint8_t owned_begin[8], owned_end[8], left_turn[8], right_turn[8];
    std::uint32_t left_byte, right_byte;
  };

  /// A run of ghosts in one word of the copy: bits [begin, end) of it, from bit `bit` of the stream on.
  struct LooseRun {
    std::uint32_t at, bit;
    std::uint8_t begin, end;

    std::uint64_t mask() const { return bits_between(begin, end); }
  };

  std::size_t patch_count() const { return patches_.size() - 1; }
  std::span<const Column> columns(std::size_t p) const {
    return {columns_.data() + patches_[p].column_begin, columns_.data() + patches_[p + 1].column_begin};
  }
  /// First word of a patch in the state; patch_count() gives the end.
  std::uint32_t word_begin(std::size_t p) const { return columns_[patches_[p].column_begin].word_begin; }
  const Group* groups(std::size_t p) const { return groups_.data() + patches_[p].group_begin; }
  std::span<const LooseRun> loose_runs(std::size_t p) const {
    return {loose_.data() + patches_[p].loose_begin, loose_.data() + patches_[p + 1].loose_begin};
  }
  /// What each patch sends to others. Ghosts that repeat no cell are sent bit 0 of a patch, which is
  /// always empty.
  const SentBits& sent() const { return sent_; }
  std::size_t word_count() const { return columns_.back().word_begin; }
  std::size_t owned_count() const { return owned_count_; }
  /// Words that the copy of any patch takes, with what may be read behind it.
  std::size_t copy_words() const { return copy_words_; }
  std::size_t bytes() const;

  /// Bit of a slot of the surface it was made from.
  std::uint32_t bit_of(const Surface& surface, std::uint32_t slot) const;

  /// Calls visit(word, mask of its owned bits) for the words of a patch that have some, in ascending order.
  template <typename Visit>
  void for_owned_words(std::size_t p, Visit&& visit) const {
    const Group* group = groups(p);
    for (const Column& column : columns(p)) {
      for (std::uint32_t g = 0; g < column.groups(); ++g) {
        const Group* some = g < column.inside ? nullptr : group++;
        for (std::uint32_t k = 0; k < std::min(8u, column.rows - 1 - 8 * g); ++k) {
          const std::uint64_t mask =
              some == nullptr ? ~std::uint64_t{0} : bits_between(some->owned_begin[k], some->owned_end[k]);
          if (mask != 0) visit(column.word_begin + 1 + 8 * g + k, mask);
        }
      }
    }
  }

 private:
  struct Builder;
  struct Patch {
    std::uint32_t column_begin;  ///< first of its word columns
    std::uint32_t group_begin;   ///< first of its groups
    std::uint32_t loose_begin;   ///< first of its loose runs
    std::int32_t origin;         ///< grid column of bit 0 of word column 0
  };

  static std::uint64_t bits_between(unsigned begin, unsigned end) {
    return begin >= end ? 0 : ~std::uint64_t{0} >> (64 - (end - begin)) << begin;
  }
  std::uint32_t bit_at(std::uint32_t patch, std::uint32_t row_index, std::int32_t column) const;

  std::vector<Patch> patches_;   // one more at the end
  std::vector<Column> columns_;  // one more at the end
  std::vector<Group> groups_;
  std::vector<LooseRun> loose_;
  SentBits sent_;
  std::size_t owned_count_ = 0, copy_words_ = 0;
};

}  // namespace verdigris
