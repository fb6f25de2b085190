#include "verdigris/automaton/packed_surface.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "bit_requests.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

}  // namespace

// Lays out one patch after the other: where the cells of each word are, then what it asks of others for its
// ghosts. When all have asked, what each patch sends is put in order.
struct PackedSurface::Builder {
  using Use = BitRequests::Use;

  // The bits of one word: owned [owned_begin, owned_end), ghosts the others of [begin, end), whose sources
  // are from `first_source` on.
  struct Word {
    std::uint32_t first_source = 0;
    std::uint8_t begin = 0, end = 0, owned_begin = 0, owned_end = 0;
  };
  // What a ghost repeats: a bit of a patch.
  struct Source {
    std::uint32_t patch = none, bit = 0;
  };
  // Ghosts [begin, end) of a word that one patch sends.
  struct Run {
    std::uint32_t word;
    unsigned begin, end;
    std::uint32_t patch;
  };
  // A word of 64 bits is read where a byte begins, so that it holds at least so many of those wanted.
  static constexpr unsigned most_together = 57;

  PackedSurface& packed;
  const Surface& surface;
  std::vector<std::uint32_t> source_of = ghost_sources(surface, none);
  std::vector<Word> words = {};          // of the patch being laid out
  std::vector<Source> sources = {};      // of its ghosts
  std::vector<Run> runs = {}, odd = {};  // of one side of a group; of a group, those that do not fit it
  BitRequests requests = {};

  // The word columns of a patch, from word `word` of the state on; returns where the next patch begins.
  std::uint64_t add_columns(std::size_t p, std::uint64_t word) {
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
    if (left < right) packed.patches_[p].origin = left;
    for (std::int32_t from = left; from < right; from += 64) {
      Column column{static_cast<std::uint32_t>(word), 0, 0};
      for (std::uint32_t r = first; r < last; ++r) {
        const std::int32_t begin = from_column(rows[r].begin, r);
        const std::int32_t end = begin + static_cast<std::int32_t>(rows.data()[r + 1].begin - rows[r].begin);
        if (begin < from + 64 && end > from) column.rows = r - first + 1;
      }
      packed.columns_.push_back(column);
      word += column.rows;
    }
    return word;
  }

  Source source_at(std::uint32_t slot) const {
    const std::uint32_t row = surface.row_of(slot), patch = surface.patch_of_row(row);
    const std::uint32_t bit = packed.bit_at(patch, row - surface.row_begin(patch),
                                            static_cast<std::int32_t>(slot - surface.rows()[row].base));
    return {patch, bit - 64 * packed.word_begin(patch)};
  }

  // Which bits of each word are which, and where each ghost's comes from.
  void read_cells(std::uint32_t p) {
    const auto rows = surface.rows();
    const std::uint32_t begin = packed.word_begin(p), end = packed.word_begin(p + 1);
    words.assign(end - begin, Word{});
    sources.clear();
    for (std::uint32_t r = surface.row_begin(p); r < surface.row_end(p); ++r) {
      const Row& row = rows[r];
      // Calls visit(word, first bit, one past the last, first slot) for the words that slots lie in.
      const auto each_word = [&](std::uint32_t slot, std::uint32_t last, auto&& visit) {
        while (slot < last) {
          const std::uint32_t bit =
              packed.bit_at(p, r - surface.row_begin(p), static_cast<std::int32_t>(slot - row.base)) -
              64 * begin;
          Word& word = words[bit / 64];
          const unsigned from = bit % 64, to = std::min(64u, from + (last - slot));
          if (word.end == 0) {
            word.begin = static_cast<std::uint8_t>(from);
            word.first_source = static_cast<std::uint32_t>(sources.size());
          }
          word.end = static_cast<std::uint8_t>(to);
          visit(word, from, to, slot);
          slot += to - from;
        }
      };
      const auto add_ghosts = [&](Word&, unsigned from, unsigned to, std::uint32_t slot) {
        for (const std::uint32_t source : std::span(source_of).subspan(slot, to - from))
          sources.push_back(source == none ? Source{} : source_at(source));
      };
      each_word(row.begin, row.run_begin, add_ghosts);
      each_word(row.run_begin, row.run_end, [](Word& word, unsigned from, unsigned to, std::uint32_t) {
        word.owned_begin = static_cast<std::uint8_t>(from);
        word.owned_end = static_cast<std::uint8_t>(to);
      });
      each_word(row.run_end, rows.data()[r + 1].begin, add_ghosts);
    }
    // A word without owned bits has its ghosts on the left.
    for (Word& word : words)
      if (word.owned_end == 0) word.owned_begin = word.owned_end = 64;
  }

  const Source& source(std::uint32_t word, unsigned ghost) const {
    const Word& w = words[word];
    const unsigned owned = ghost < w.owned_begin ? 0 : w.owned_end - w.owned_begin;
    return sources[w.first_source + (ghost - w.begin) - owned];
  }

  // Calls visit(run) for the parts of bits [begin, end) of a word that come from one patch each. Ghosts of
  // nothing go with those beside them.
  template <typename Visit>
  void each_run(std::uint32_t p, std::uint32_t word, unsigned begin, unsigned end, Visit&& visit) {
    std::uint32_t patch = none;
    for (unsigned bit = begin; bit < end; ++bit) {
      const std::uint32_t its = source(word, bit).patch;
      if (its == none || its == patch) continue;
      if (patch != none) {
        visit(Run{word, begin, bit, patch});
        begin = bit;
      }
      patch = its;
    }
    if (begin < end) visit(Run{word, begin, end, patch == none ? p : patch});
  }

  // Bit 0 of a patch is never owned: ghosts of nothing repeat it.
  void ask_for(const Run& run) {
    for (unsigned bit = run.begin; bit < run.end; ++bit) requests.add(source(run.word, bit).bit);
  }
  void add_loose(const Run& run, std::uint32_t at) {
    requests.begin(run.patch, Use::loose, packed.loose_.size());
    ask_for(run);
    packed.loose_.push_back(
        {at, 0, static_cast<std::uint8_t>(run.begin), static_cast<std::uint8_t>(run.end)});
  }

  // The patch that most ghosts of the runs come from, the first of equals.
  std::uint32_t main_sender() const {
    std::uint32_t best = none;
    unsigned most = 0;
    for (const Run& candidate : runs) {
      unsigned bits = 0;
      for (const Run& run : runs)
        if (run.patch == candidate.patch) bits += run.end - run.begin;
      if (bits > most) {
        most = bits;
        best = candidate.patch;
      }
    }
    return best;
  }

  // The ghosts on one side of eight words: what its main sender has for it comes side by side, if it fits.
  template <typename Ends>
  void add_side(std::uint32_t p, Use side, std::uint32_t first_word, std::uint32_t count,
                std::uint8_t (&turn)[8], Ends&& ends) {
    runs.clear();
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto [begin, end] = ends(words[first_word + k]);
      each_run(p, first_word + k, begin, end, [&](const Run& run) { runs.push_back(run); });
    }
    const std::uint32_t sender = main_sender();
    const std::size_t first = requests.bit_count();
    std::uint32_t placed = none;
    for (const Run& run : runs) {
      const std::size_t at = requests.bit_count() - first;
      if (run.patch != sender || run.word == placed || at + (run.end - run.begin) > most_together) {
        odd.push_back(run);
        continue;
      }
      if (at == 0) requests.begin(sender, side, packed.groups_.size());
      turn[run.word - first_word] = static_cast<std::uint8_t>((64 + run.begin - at) % 64);
      ask_for(run);
      placed = run.word;
    }
  }

  void add_group(std::uint32_t p, std::uint32_t first_word, std::uint32_t count, std::uint32_t copy_at) {
    Group group{};
    for (std::uint32_t k = 0; k < count; ++k) {
      group.owned_begin[k] = words[first_word + k].owned_begin;
      group.owned_end[k] = words[first_word + k].owned_end;
    }
    odd.clear();
    add_side(p, Use::left, first_word, count, group.left_turn, [](const Word& w) {
      return std::pair<unsigned, unsigned>(w.begin, std::min(w.end, w.owned_begin));
    });
    add_side(p, Use::right, first_word, count, group.right_turn,
             [](const Word& w) { return std::pair<unsigned, unsigned>(w.owned_end, w.end); });
    packed.groups_.push_back(group);
    for (const Run& run : odd) add_loose(run, copy_at + run.word - first_word);
  }

  void add_patch(std::uint32_t p) {
    Patch& patch = packed.patches_[p];
    patch.group_begin = static_cast<std::uint32_t>(packed.groups_.size());
    patch.loose_begin = static_cast<std::uint32_t>(packed.loose_.size());
    read_cells(p);
    std::uint32_t first = 0, copy = 0, widest = 0;
    for (std::uint32_t k = patch.column_begin; k < packed.patches_[p + 1].column_begin; ++k) {
      Column& column = packed.columns_[k];
      const auto all_ghosts = [&](std::uint32_t w) {
        each_run(p, first + w, words[first + w].begin, words[first + w].end,
                 [&](const Run& run) { add_loose(run, copy + 7 + w); });
      };
      if (column.rows > 0) all_ghosts(0);
      const auto owned = [](const Word& w) { return w.owned_begin == 0 && w.owned_end == 64; };
      const auto begin = words.begin() + first + 1;
      while (8 * column.inside + 8 < column.rows &&
             std::all_of(begin + 8 * column.inside, begin + 8 * column.inside + 8, owned))
        ++column.inside;
      for (std::uint32_t g = column.inside; g < column.groups(); ++g)
        add_group(p, first + 1 + 8 * g, std::min(8u, column.rows - 1 - 8 * g), copy + 8 + 8 * g);
      for (std::uint32_t w = 1 + 8 * column.groups(); w < column.rows; ++w) all_ghosts(w);
      first += column.rows;
      copy += column.pitch();
      widest = std::max(widest, column.pitch());
    }
    // Beside the last word column as many words may be read as it has itself.
    packed.copy_words_ = std::max<std::size_t>(packed.copy_words_, copy + widest);
  }

  // Tells a group or a loose run that its bits begin at bit `at` of the stream.
  void tell(const BitRequests::Request& request, std::uint32_t at) {
    if (request.use == Use::loose) {
      packed.loose_[request.index].bit = at;
      return;
    }
    Group& group = packed.groups_[request.index];
    const bool left = request.use == Use::left;
    (left ? group.left_byte : group.right_byte) = at / 8;
    for (std::uint8_t& turn : left ? group.left_turn : group.right_turn)
      turn = static_cast<std::uint8_t>((64 + turn - at % 8) % 64);
  }

  // What each patch sends: request by request as they were made.
  void send() {
    std::vector<std::uint32_t> sent;
    requests.by_sender(
        packed.patch_count(),
        [&](const BitRequests::Request& request, std::span<const std::uint32_t> bits) {
          const std::size_t stream_begin = packed.sent_.begin(packed.sent_.patch_count());
          tell(request, static_cast<std::uint32_t>(stream_begin + sent.size()));
          sent.insert(sent.end(), bits.begin(), bits.end());
        },
        [&](std::uint32_t) {
          packed.sent_.add_patch(sent);
          sent.clear();
        });
  }
};

PackedSurface::PackedSurface(const Surface& surface) {
  if (surface.link_kind() != LinkKind::unfolded)
    throw std::invalid_argument("packed cells need unfolded links");
  owned_count_ = surface.owned_count();
  Builder builder{*this, surface};
  const auto count = static_cast<std::uint32_t>(surface.patch_count());
  patches_.reserve(count + 1);
  std::uint64_t words = 0;
  for (std::uint32_t p = 0; p <= count; ++p) {
    patches_.push_back({static_cast<std::uint32_t>(columns_.size()), 0, 0, 0});
    if (p < count) words = builder.add_columns(p, words);
    if (words > (std::uint64_t{1} << 26))
      throw InputError("cells", "more than 2^32 bits of packed cells", "use larger cells");
  }
  columns_.push_back({static_cast<std::uint32_t>(words), 0, 0});
  for (std::uint32_t p = 0; p < count; ++p) builder.add_patch(p);
  patches_[count].group_begin = static_cast<std::uint32_t>(groups_.size());
  patches_[count].loose_begin = static_cast<std::uint32_t>(loose_.size());
  builder.send();
  columns_ = large_copy(columns_);
  groups_ = large_copy(groups_);
  loose_ = large_copy(loose_);
  sent_.settle();
}

std::uint32_t PackedSurface::bit_at(std::uint32_t patch, std::uint32_t row_index, std::int32_t column) const {
  const Patch& p = patches_[patch];
  const auto offset = static_cast<std::uint32_t>(column - p.origin);
  return (columns_[p.column_begin + offset / 64].word_begin + row_index) * 64 + offset % 64;
}

std::uint32_t PackedSurface::bit_of(const Surface& surface, std::uint32_t slot) const {
  const std::uint32_t row = surface.row_of(slot), patch = surface.patch_of_row(row);
  return bit_at(patch, row - surface.row_begin(patch),
                static_cast<std::int32_t>(slot - surface.rows()[row].base));
}

std::size_t PackedSurface::bytes() const {
  return patches_.size() * sizeof(Patch) + columns_.size() * sizeof(Column) + groups_.size() * sizeof(Group) +
         loose_.size() * sizeof(LooseRun) + sent_.bytes();
}

}  // namespace verdigris
