#pragma once
// Which cells repeat the state of which: the joints between the grids of neighbouring triangles.

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/base/prefetch.hpp"

namespace verdigris {

/// How the grids of neighbouring triangles are joined.
enum class LinkKind : std::uint8_t {
  unfolded,   ///< a cell beyond an edge is a ghost: it copies the owned cell nearest to its unfolded centre
  projected,  ///< the cells that an edge crosses are paired by projection on it (Gobron & Chiba 1999, Fig. 7)
};

/// For each source slot, the slots that take its state: ghosts (unfolded) or partners (projected).
///
/// Stored once, ordered by source: one bit a slot tells whether it is a source, a number every 64 slots where
/// the targets of their sources begin, one bit a target whether it is the last of its source.
class Links {
 public:
  Links() = default;
  /// From (source, target) pairs in ascending order, over slots 0..slot_count-1.
  Links(std::size_t slot_count, std::span<const std::uint64_t> sorted_pairs);

  bool is_source(std::uint32_t slot) const { return (bits_[slot >> 6] >> (slot & 63)) & 1u; }

  /// The slots that repeat `slot`; empty for most.
  [[gnu::always_inline]] std::span<const std::uint32_t> targets(std::uint32_t slot) const {
    if (!is_source(slot)) return {};
    const std::uint64_t before = bits_[slot >> 6] & ((std::uint64_t{1} << (slot & 63)) - 1);
    const std::size_t begin = skip(first_[slot >> 6], static_cast<unsigned>(std::popcount(before)));
    return {targets_.data() + begin, targets_.data() + skip(begin, 1)};
  }
  /// Asks for the memory that tells whether `slot` is a source.
  [[gnu::always_inline]] void prefetch_source(std::uint32_t slot) const {
    prefetch(bits_.data() + (slot >> 6));
    prefetch(first_.data() + (slot >> 6));
  }
  /// Asks for the memory that targets of `slot` lie in, if it has some; most sources have one.
  [[gnu::always_inline]] void prefetch_targets(std::uint32_t slot) const {
    const std::size_t at = about_first(slot);
    prefetch(targets_.data() + at);
    prefetch(last_.data() + (at >> 6));
  }
  /// Something to prefetch by: most often a target of `slot`, a source; else one of a source near it.
  std::uint32_t likely_target(std::uint32_t slot) const { return targets_[about_first(slot)]; }

  /// Calls visit(source, targets) for every source in ascending order: a whole refresh.
  template <typename Visit>
  void for_each(Visit&& visit) const {
    for_each_between(0, bits_.size(), visit);
  }
  /// The same for the sources among slots 64 * first_word ... 64 * last_word - 1: a share of the work.
  template <typename Visit>
  void for_each_between(std::size_t first_word, std::size_t last_word, Visit&& visit) const {
    if (first_word >= last_word) return;
    std::size_t begin = first_[first_word], at = begin >> 6;
    std::uint64_t ends = last_[at] >> (begin & 63) << (begin & 63);  // of lists not visited yet
    for (std::size_t word = first_word; word < last_word; ++word) {
      for (std::uint64_t rest = bits_[word]; rest != 0; rest &= rest - 1) {
        while (ends == 0) ends = last_[++at];
        const std::size_t end = 64 * at + static_cast<std::size_t>(std::countr_zero(ends)) + 1;
        ends &= ends - 1;
        visit(static_cast<std::uint32_t>(64 * word + static_cast<std::size_t>(std::countr_zero(rest))),
              std::span<const std::uint32_t>(targets_.data() + begin, targets_.data() + end));
        begin = end;
      }
    }
  }
  std::size_t word_count() const { return bits_.size(); }
  std::size_t size() const { return targets_.size(); }
  /// The targets of all sources, one source after the other: spans of `targets` and `for_each` lie in it.
  std::span<const std::uint32_t> all_targets() const { return targets_; }
  /// [index into all_targets()] the source of each.
  std::vector<std::uint32_t> sources_of_targets() const;
  std::size_t bytes() const;

 private:
  // As if every source before it in its word had one target.
  std::size_t about_first(std::uint32_t slot) const {
    const std::uint64_t before = bits_[slot >> 6] & ((std::uint64_t{1} << (slot & 63)) - 1);
    return first_[slot >> 6] + static_cast<unsigned>(std::popcount(before));
  }
  // Index past the targets of `sources` sources, of which the first has its targets from `at` on.
  [[gnu::always_inline]] std::size_t skip(std::size_t at, unsigned sources) const {
    if (sources == 0) return at;
    for (;; at += 64) {
      const unsigned shift = at & 63;
      // Two words hold the next 64 bits; << 1 first, since a shift by 64 means nothing.
      std::uint64_t last = last_[at >> 6] >> shift | last_[(at >> 6) + 1] << 1 << (63 - shift);
      const auto ends = static_cast<unsigned>(std::popcount(last));
      if (ends >= sources) {
#ifdef __BMI2__
        last = __builtin_ia32_pdep_di(std::uint64_t{1} << (sources - 1), last);
#else
        for (; sources > 1; --sources) last &= last - 1;
#endif
        return at + static_cast<unsigned>(std::countr_zero(last)) + 1;
      }
      sources -= ends;
    }
  }

  std::vector<std::uint64_t> bits_;   // [slot / 64]
  std::vector<std::uint32_t> first_;  // [slot / 64] into targets_
  std::vector<std::uint64_t> last_;   // [index into targets_ / 64], one more at the end
  std::vector<std::uint32_t> targets_;
};

}  // namespace verdigris
