#include "verdigris/automaton/packed_surface.hpp"

#include <limits>
#include <stdexcept>

#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t no_source = 0xFFFFFFFFu;

}  // namespace

// Lays out one patch after the other: where the cells of each word are, then how its ghosts come to it.
struct PackedSurface::Builder {
  // The bits of one word: owned [owned_begin, owned_end), ghosts the others of [begin, end).
  struct Word {
    std::uint8_t begin = 0, end = 0, owned_begin = 0, owned_end = 0;
  };
  struct Run {
    unsigned begin, end;
  };
  // A run that does not fit its group: its word in the patch and in the copy.
  struct OddRun {
    Run run;
    std::uint32_t word, at;
  };

  PackedSurface& packed;
  const Surface& surface;
  std::vector<std::uint32_t> source_of = ghost_sources(surface, no_source);
  std::vector<Word> words = {};               // of the patch being laid out
  std::vector<std::uint32_t> source_at = {};  // [bit] of the patch: bit of the state that a ghost copies
  std::vector<std::uint32_t> stream = {};     // the sources of its ghosts in the order of gathering
  std::vector<OddRun> odd = {};               // of the group being made

  // The word columns of a patch; returns how many words they have.
  std::uint64_t add_columns(std::size_t p) {
    const auto rows = surface.rows();
    const std::uint32_t first = surface.row_begin(p), last = surface.row_end(p);
    const auto from_column = [&](std::uint32_t slot, std::uint32_t r) {
      return static_cast<std::int32_t>(slot - rows[r].base);
    };
    std::int32_t left = std::numeric_limits<std::int32_t>::max(), right = -left;
    for (std::uint32_t r = first; r < last; ++r) {
      if (rows.data()[r].begin == rows.data()[r + 1].begin) continue;
      left = std::min(left, from_column(rows[r].begin, r));
      right = std::max(right, from_column(rows.data()[r + 1].begin, r));
    }
    std::uint64_t words = 0;
    if (left < right) packed.patches_[p].origin = left;
    for (std::int32_t from = left; from < right; from += 64) {
      Column column{0, 0};
      for (std::uint32_t r = first; r < last; ++r) {
        const std::int32_t begin = from_column(rows[r].begin, r);
        const std::int32_t end = begin + static_cast<std::int32_t>(rows.data()[r + 1].begin - rows[r].begin);
        if (begin < from + 64 && end > from) column.rows = r - first + 1;
      }
      packed.columns_.push_back(column);
      words += column.rows;
    }
    return words;
  }

  // Which bits of each word are which, and where each ghost's comes from.
  void read_cells(std::uint32_t p) {
    const auto rows = surface.rows();
    const std::uint32_t begin = packed.patches_[p].word_begin, end = packed.patches_[p + 1].word_begin;
    words.assign(end - begin, Word{});
    source_at.assign(std::size_t{64} * (end - begin), 0);
    for (std::uint32_t r = surface.row_begin(p); r < surface.row_end(p); ++r) {
      const Row& row = rows[r];
      for (std::uint32_t slot = row.begin; slot < rows.data()[r + 1].begin; ++slot) {
        const std::uint32_t bit =
            packed.bit_at(p, r - surface.row_begin(p), static_cast<std::int32_t>(slot - row.base)) -
            64 * begin;
        Word& word = words[bit / 64];
        const auto at = static_cast<std::uint8_t>(bit % 64);
        if (word.end == 0) word.begin = at;
        word.end = static_cast<std::uint8_t>(at + 1);
        if (slot >= row.run_begin && slot < row.run_end) {
          if (word.owned_end == 0) word.owned_begin = at;
          word.owned_end = static_cast<std::uint8_t>(at + 1);
        } else if (source_of[slot] != no_source) {
          source_at[bit] = packed.bit_of(surface, source_of[slot]);
        }
      }
    }
    // A word without owned bits has its ghosts on the left.
    for (Word& word : words)
      if (word.owned_end == 0) word.owned_begin = word.owned_end = 64;
  }

  void add_to_stream(std::uint32_t word, Run run) {
    for (unsigned bit = run.begin; bit < run.end; ++bit) stream.push_back(source_at[64 * word + bit]);
  }
  void add_loose(std::uint32_t word, std::uint32_t at, Run run) {
    if (run.begin >= run.end) return;
    packed.loose_.push_back(
        {at, static_cast<std::uint32_t>(stream.size()), bits_between(run.begin, run.end)});
    add_to_stream(word, run);
  }

  // The runs of one side of eight words: those that fit into 64 bits go into the stream side by side.
  template <typename RunOf>
  std::uint16_t add_side(std::uint32_t first_word, std::uint32_t count, std::uint32_t copy_at,
                         std::uint8_t (&turn)[8], RunOf&& run_of) {
    const std::size_t byte = stream.size() / 8;
    const bool near = byte <= std::numeric_limits<std::uint16_t>::max();
    for (std::uint32_t k = 0; k < count; ++k) {
      const Run run = run_of(words[first_word + k]);
      if (run.begin >= run.end) continue;
      const std::size_t at = stream.size() - 8 * byte;
      if (near && at + (run.end - run.begin) <= 64) {
        turn[k] = static_cast<std::uint8_t>((64 + run.begin - at) % 64);
        add_to_stream(first_word + k, run);
      } else {
        odd.push_back({run, first_word + k, copy_at + k});
      }
    }
    return near ? static_cast<std::uint16_t>(byte) : std::uint16_t{0};
  }

  void add_group(std::uint32_t first_word, std::uint32_t count, std::uint32_t copy_at) {
    Group group{};
    for (std::uint32_t k = 0; k < count; ++k) {
      group.owned_begin[k] = words[first_word + k].owned_begin;
      group.owned_end[k] = words[first_word + k].owned_end;
    }
    odd.clear();
    group.left_byte = add_side(first_word, count, copy_at, group.left_turn, [](const Word& w) {
      return Run{w.begin, std::min(w.end, w.owned_begin)};
    });
    group.right_byte = add_side(first_word, count, copy_at, group.right_turn, [](const Word& w) {
      return Run{w.owned_end, w.end};
    });
    packed.groups_.push_back(group);
    for (const OddRun& run : odd) add_loose(run.word, run.at, run.run);
  }

  void add_patch(std::uint32_t p) {
    Patch& patch = packed.patches_[p];
    patch.group_begin = static_cast<std::uint32_t>(packed.groups_.size());
    patch.loose_begin = static_cast<std::uint32_t>(packed.loose_.size());
    read_cells(p);
    stream.clear();
    std::uint32_t first = 0, copy = 0, widest = 0;
    for (std::uint32_t k = patch.column_begin; k < packed.patches_[p + 1].column_begin; ++k) {
      Column& column = packed.columns_[k];
      const auto all_ghosts = [&](std::uint32_t w) {
        add_loose(first + w, copy + 7 + w, {words[first + w].begin, words[first + w].end});
      };
      if (column.rows > 0) all_ghosts(0);
      const auto owned = [](const Word& w) { return w.owned_begin == 0 && w.owned_end == 64; };
      const auto begin = words.begin() + first + 1;
      while (8 * column.inside + 8 < column.rows &&
             std::all_of(begin + 8 * column.inside, begin + 8 * column.inside + 8, owned))
        ++column.inside;
      for (std::uint32_t g = column.inside; g < column.groups(); ++g)
        add_group(first + 1 + 8 * g, std::min(8u, column.rows - 1 - 8 * g), copy + 8 + 8 * g);
      for (std::uint32_t w = 1 + 8 * column.groups(); w < column.rows; ++w) all_ghosts(w);
      first += column.rows;
      copy += column.pitch();
      widest = std::max(widest, column.pitch());
    }
    packed.sources_.add_patch(stream);
    // Beside the last word column as many words may be read as it has itself.
    packed.copy_words_ = std::max<std::size_t>(packed.copy_words_, copy + widest);
  }
};

PackedSurface::PackedSurface(const Surface& surface) {
  if (surface.link_kind() != LinkKind::unfolded)
    throw std::invalid_argument("packed cells need unfolded links");
  owned_count_ = surface.owned_count();
  Builder builder{*this, surface};
  const auto count = static_cast<std::uint32_t>(surface.patch_count());
  patches_.reserve(count + 1);
  // Word 0 of the state is kept empty, so patches begin at word 1.
  std::uint64_t words = 1;
  for (std::uint32_t p = 0; p <= count; ++p) {
    patches_.push_back(
        {static_cast<std::uint32_t>(words), static_cast<std::uint32_t>(columns_.size()), 0, 0, 0});
    if (p < count) words += builder.add_columns(p);
    if (words > (std::uint64_t{1} << 26))
      throw InputError("cells", "more than 2^32 bits of packed cells", "use larger cells");
  }
  for (std::uint32_t p = 0; p < count; ++p) builder.add_patch(p);
  patches_[count].group_begin = static_cast<std::uint32_t>(groups_.size());
  patches_[count].loose_begin = static_cast<std::uint32_t>(loose_.size());
  columns_ = large_copy(columns_);
  groups_ = large_copy(groups_);
  loose_ = large_copy(loose_);
  sources_.settle();
}

std::uint32_t PackedSurface::bit_at(std::uint32_t patch, std::uint32_t row_index, std::int32_t column) const {
  const Patch& p = patches_[patch];
  const auto offset = static_cast<std::uint32_t>(column - p.origin);
  std::uint32_t word = p.word_begin;
  for (std::uint32_t k = 0; k < offset / 64; ++k) word += columns_[p.column_begin + k].rows;
  return (word + row_index) * 64 + offset % 64;
}

std::uint32_t PackedSurface::bit_of(const Surface& surface, std::uint32_t slot) const {
  const std::uint32_t row = surface.row_of(slot), patch = surface.patch_of_row(row);
  return bit_at(patch, row - surface.row_begin(patch),
                static_cast<std::int32_t>(slot - surface.rows()[row].base));
}

std::size_t PackedSurface::bytes() const {
  return patches_.size() * sizeof(Patch) + columns_.size() * sizeof(Column) + groups_.size() * sizeof(Group) +
         loose_.size() * sizeof(LooseRun) + sources_.bytes();
}

}  // namespace verdigris
