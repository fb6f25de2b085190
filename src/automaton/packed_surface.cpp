#include "verdigris/automaton/packed_surface.hpp"

#include <algorithm>
#include <stdexcept>

#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t no_source = 0xFFFFFFFFu;

}  // namespace

PackedSurface::PackedSurface(const Surface& surface) {
  if (surface.link_kind() != LinkKind::unfolded)
    throw std::invalid_argument("packed cells need unfolded links");
  const auto rows = surface.rows();
  const std::size_t count = surface.patch_count();

  // Columns: word 0 of the state is kept empty, so patches begin at word 1.
  patches_.reserve(count + 1);
  std::uint64_t words = 1;
  for (std::size_t p = 0; p < count; ++p) {
    const std::uint32_t first = surface.row_begin(p), last = surface.row_end(p);
    Patch patch{static_cast<std::uint32_t>(words), 0, static_cast<std::uint32_t>(column_rows_.size()), 0};
    if (first < last) {
      std::int32_t left = 0x7FFFFFFF, right = -0x7FFFFFFF;
      for (std::uint32_t r = first; r < last; ++r) {
        if (rows.data()[r].begin == rows.data()[r + 1].begin) continue;
        left = std::min(left, static_cast<std::int32_t>(rows[r].begin - rows[r].base));
        right = std::max(right, static_cast<std::int32_t>(rows.data()[r + 1].begin - rows[r].base));
      }
      patch.origin = left;
      for (std::int32_t from = left; from < right; from += 64) {
        std::uint32_t needed = 0;
        for (std::uint32_t r = first; r < last; ++r) {
          const auto begin = static_cast<std::int32_t>(rows[r].begin - rows[r].base);
          const auto end = begin + static_cast<std::int32_t>(rows.data()[r + 1].begin - rows[r].begin);
          if (begin < from + 64 && end > from) needed = r - first + 1;
        }
        column_rows_.push_back(needed);
        words += needed;
      }
    }
    patches_.push_back(patch);
    largest_patch_words_ = std::max<std::size_t>(largest_patch_words_, words - patch.word_begin);
    if (words > (std::uint64_t{1} << 26))
      throw InputError("cells", "more than 2^32 bits of packed cells", "use larger cells");
  }
  patches_.push_back(
      {static_cast<std::uint32_t>(words), 0, static_cast<std::uint32_t>(column_rows_.size()), 0});

  std::vector<std::uint32_t> source_of(surface.slot_count(), no_source);
  surface.links().for_each([&](std::uint32_t source, auto targets) {
    for (const std::uint32_t ghost : targets) source_of[ghost] = source;
  });

  bits_.assign(words + 8, Bits{});
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ghosts;  // bit, source slot
  for (std::uint32_t p = 0; p < count; ++p) {
    patches_[p].ghost_begin = static_cast<std::uint32_t>(ghost_sources_.size());
    ghosts.clear();
    for (std::uint32_t r = surface.row_begin(p); r < surface.row_end(p); ++r) {
      const Row& row = rows[r];
      const std::uint32_t end = rows.data()[r + 1].begin;
      const auto bit_at_slot = [&](std::uint32_t slot) {
        return bit_at(p, r - surface.row_begin(p), static_cast<std::int32_t>(slot - row.base));
      };
      for (std::uint32_t slot = row.begin; slot < end; ++slot) {
        const std::uint32_t bit = bit_at_slot(slot);
        Bits& bits = bits_[bit >> 6];
        const auto at = static_cast<std::uint8_t>(bit & 63);
        if (bits.end == 0) bits.begin = at;
        bits.end = static_cast<std::uint8_t>(at + 1);
        if (slot >= row.run_begin && slot < row.run_end) {
          if (bits.owned_end == 0) bits.owned_begin = at;
          bits.owned_end = static_cast<std::uint8_t>(at + 1);
        } else {
          ghosts.emplace_back(bit, source_of[slot]);
        }
      }
      owned_count_ += row.run_end - row.run_begin;
    }
    std::sort(ghosts.begin(), ghosts.end());
    for (const auto& [bit, source] : ghosts)
      ghost_sources_.push_back(source == no_source ? 0 : bit_of(surface, source));
    // Whole vectors of sources: the rest copies the bit that is always empty.
    while (ghost_sources_.size() % 16 != 0) ghost_sources_.push_back(0);
  }
  patches_[count].ghost_begin = static_cast<std::uint32_t>(ghost_sources_.size());
}

std::uint32_t PackedSurface::bit_at(std::uint32_t patch, std::uint32_t row_index, std::int32_t column) const {
  const Patch& p = patches_[patch];
  const auto offset = static_cast<std::uint32_t>(column - p.origin);
  std::uint32_t word = p.word_begin;
  for (std::uint32_t k = 0; k < offset / 64; ++k) word += column_rows_[p.column_begin + k];
  return (word + row_index) * 64 + offset % 64;
}

std::uint32_t PackedSurface::bit_of(const Surface& surface, std::uint32_t slot) const {
  const std::uint32_t row = surface.row_of(slot), patch = surface.patch_of_row(row);
  return bit_at(patch, row - surface.row_begin(patch),
                static_cast<std::int32_t>(slot - surface.rows()[row].base));
}

std::size_t PackedSurface::bytes() const {
  return patches_.size() * sizeof(Patch) + column_rows_.size() * 4 + bits_.size() * sizeof(Bits) +
         ghost_sources_.size() * 4;
}

}  // namespace verdigris
