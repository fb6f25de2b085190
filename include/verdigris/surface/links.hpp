#pragma once
// Which cells repeat the state of which: the joints between the grids of neighbouring triangles.

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace verdigris {

/// How the grids of neighbouring triangles are joined.
enum class LinkKind : std::uint8_t {
  unfolded,   ///< a cell beyond an edge is a ghost: it copies the owned cell nearest to its unfolded centre
  projected,  ///< the cells that an edge crosses are paired by projection on it (Gobron & Chiba 1999, Fig. 7)
};

/// For each source slot, the slots that take its state: ghosts (unfolded) or partners (projected).
///
/// Stored once, ordered by source: one bit a slot tells whether it is a source, a rank every 64 slots finds
/// its list.
class Links {
 public:
  Links() = default;
  /// From (source, target) pairs in ascending order, over slots 0..slot_count-1.
  Links(std::size_t slot_count, std::span<const std::uint64_t> sorted_pairs);

  bool is_source(std::uint32_t slot) const { return (bits_[slot >> 6] >> (slot & 63)) & 1u; }

  /// The slots that repeat `slot`; empty for most.
  [[gnu::always_inline]] std::span<const std::uint32_t> targets(std::uint32_t slot) const {
    if (!is_source(slot)) return {};
    const std::uint64_t below = bits_[slot >> 6] & ((std::uint64_t{1} << (slot & 63)) - 1);
    const std::uint32_t k = rank_[slot >> 6] + static_cast<std::uint32_t>(std::popcount(below));
    return {targets_.data() + offset_[k], targets_.data() + offset_[k + 1]};
  }

  /// Calls visit(source, targets) for every source in ascending order: a whole refresh.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for_each_between(0, bits_.size(), visit);
  }
  /// The same for the sources among slots 64 * first_word ... 64 * last_word - 1: a share of the work.
  template <typename Visit>
  void for_each_between(std::size_t first_word, std::size_t last_word, Visit&& visit) const {
    for (std::size_t word = first_word; word < last_word; ++word) {
      std::uint32_t k = rank_[word];
      for (std::uint64_t rest = bits_[word]; rest != 0; rest &= rest - 1, ++k)
        visit(static_cast<std::uint32_t>(64 * word + static_cast<std::size_t>(std::countr_zero(rest))),
              std::span<const std::uint32_t>(targets_.data() + offset_[k], targets_.data() + offset_[k + 1]));
    }
  }
  std::size_t word_count() const { return bits_.size(); }
  std::size_t size() const { return targets_.size(); }
  /// The targets of all sources, one source after the other: spans of `targets` and `for_each` lie in it.
  std::span<const std::uint32_t> all_targets() const { return targets_; }
  std::size_t bytes() const;

 private:
  std::vector<std::uint64_t> bits_;    // [slot / 64]
  std::vector<std::uint32_t> rank_;    // [slot / 64] sources before this word
  std::vector<std::uint32_t> offset_;  // [source rank] into targets_, one more at the end
  std::vector<std::uint32_t> targets_;
};

}  // namespace verdigris
