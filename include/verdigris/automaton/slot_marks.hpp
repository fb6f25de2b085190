#pragma once
// A bit a slot: which cells a front need not take up, because it has them already or never will.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verdigris/automaton/slot_list.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/base/prefetch.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A marked slot never becomes a candidate: it is one, it does not evolve, or it is settled. Functions with
/// `Shared` may be called by several threads at once. The surface must outlive it.
class SlotMarks {
 public:
  static constexpr std::size_t most_marked = 9;  ///< a slot and its neighbours

  /// Everything marked.
  explicit SlotMarks(const Surface& surface)
      : rows_(surface.rows().data()),
        marks_(large_vector(surface.slot_count() / 64 + 2, ~std::uint64_t{0})) {}

  std::size_t bytes() const { return marks_.size() * sizeof(marks_[0]); }

  /// Unmarks the slots of begin..end-1 that are `open`.
  template <typename Open>
  void unmark_between(std::uint32_t begin, std::uint32_t end, Open&& open) {
    for (std::uint32_t slot = begin; slot < end;) {
      const std::uint32_t stop = std::min(end, (slot | 63u) + 1u);
      std::uint64_t bits = 0;
      for (std::uint32_t s = slot; s < stop; ++s) bits |= std::uint64_t{open(s)} << (s & 63u);
      marks_[slot >> 6] &= ~bits;
      slot = stop;
    }
  }

  template <bool Shared>
  void unmark(std::uint32_t slot) {
    const std::uint64_t keep = ~(std::uint64_t{1} << (slot & 63));
    if constexpr (Shared)
      std::atomic_ref<std::uint64_t>(marks_[slot >> 6]).fetch_and(keep, std::memory_order_relaxed);
    else
      marks_[slot >> 6] &= keep;
  }

  /// Asks for the memory that the mark of `slot` lies in.
  [[gnu::always_inline]] void prefetch_mark(std::uint32_t slot) const {
    prefetch_for_writing(marks_.data() + (slot >> 6));
  }

  void mark(std::uint32_t slot) { marks_[slot >> 6] |= std::uint64_t{1} << (slot & 63); }

  /// Of the `wanted` (one bit each) slots from `first` on, those that were not marked; they are now.
  template <bool Shared>
  std::uint32_t test_and_mark(std::uint32_t first, std::uint32_t wanted) {
    const std::size_t word = first >> 6;
    const unsigned shift = first & 63;
    std::uint64_t low = std::uint64_t{wanted} << shift;
    std::uint64_t fresh = claim<Shared>(marks_[word], low) >> shift;
    if (shift > 61) {
      const std::uint64_t high = std::uint64_t{wanted} >> (64 - shift);
      if (high != 0) fresh |= claim<Shared>(marks_[word + 1], high) << (64 - shift);
    }
    return static_cast<std::uint32_t>(fresh);
  }

  /// Puts the unmarked ones of a slot and its eight neighbours on `next`, which has room for them, and marks
  /// them. `Ghost`: the slot may lie beyond the evolving cells of its row.
  template <bool Shared, bool Ghost>
  void mark_around(std::uint32_t slot, std::uint32_t row, SlotList<Place>& next) {
    const Row* rows = rows_ + row;
    const std::uint32_t column = slot - rows[0].base;
    for (int d = -1; d <= 1; ++d) {
      const Row& r = rows[d];
      const std::uint32_t first = r.base + column - 1;
      std::uint32_t wanted = 7;
      if constexpr (Ghost) {
        // Around a ghost the row may end before the column: those slots belong to another row, and may evolve
        // there.
        wanted = 0;
        for (std::uint32_t k = 0; k < 3; ++k)
          wanted |= static_cast<std::uint32_t>(first + k - r.run_begin < r.run_end - r.run_begin) << k;
        if (wanted == 0) continue;
      }
      const std::uint32_t fresh = test_and_mark<Shared>(first, wanted);
      const std::uint32_t index = row + static_cast<std::uint32_t>(d);
      next.put_if({index, first}, (fresh & 1u) != 0);
      next.put_if({index, first + 1}, (fresh & 2u) != 0);
      next.put_if({index, first + 2}, (fresh & 4u) != 0);
    }
  }

 private:
  template <bool Shared>
  static std::uint64_t claim(std::uint64_t& word, std::uint64_t bits) {
    if constexpr (Shared) {
      std::atomic_ref<std::uint64_t> shared(word);
      const std::uint64_t missing = bits & ~shared.load(std::memory_order_relaxed);
      return missing == 0 ? 0 : bits & ~shared.fetch_or(missing, std::memory_order_relaxed);
    } else {
      const std::uint64_t fresh = bits & ~word;
      word |= bits;
      return fresh;
    }
  }

  const Row* rows_;
  std::vector<std::uint64_t> marks_;  // [slot / 64]
};

}  // namespace verdigris
