#pragma once
// Voronoi growth: regions grow from seeds until they meet (Gobron & Chiba 1999, "3D Surface Voronoi
// Diagram").

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"

namespace verdigris {

/// The rule. A cell with a filled side neighbour is filled in the next step; one that only touches filled
/// corners is filled with probability `corner` for each of them, in each step (0.2071 makes discs round: the
/// paper's Fig. 14).
///
/// State: arrival step and label in one word, `arrival << label_bits | label`; the smaller word came first.
///
/// *Ties.* When neighbours of several labels would fill a cell in one step: sides go before corners, and
/// among the labels of equal standing the one wins whose random word, keyed by (seed, step, cell, label), is
/// least. No order of cells or threads enters, and no label is favoured.
///
/// *Speeds.* With weights, label k may spread in step t when floor(t w_k) > floor((t - 1) w_k), w_k its speed
/// over the greatest: each label keeps a clock of its own, and its front stays as round as any.
template <typename Word>
struct VoronoiRule {
  using State = Word;
  static constexpr Word empty = std::numeric_limits<Word>::max();
  static constexpr Word blocked = empty - 1;  ///< a barrier: never filled
  static constexpr bool stamped = true;
  /// Without a chance at corners a cell beside a filled corner does not wait: such steps are done in two
  /// passes.
  bool in_place() const { return corner_threshold > 0; }
  static constexpr std::uint32_t corner_purpose = 0x564f5201, tie_purpose = 0x564f5202;

  unsigned label_bits = 1;
  std::uint64_t corner_threshold = threshold(0.2071067811865476);
  std::vector<double> speed;        ///< [label], greatest 1; empty: all the same
  std::vector<std::uint8_t> moves;  ///< [label], this step; empty: all
  Word now = 0;                     ///< words filled in this step are at least this

  static unsigned bits_for(std::uint64_t labels) {
    unsigned bits = 1;
    while ((std::uint64_t{1} << bits) < labels) ++bits;
    return bits;
  }
  /// The greatest arrival step a word can hold.
  std::uint64_t last_step() const { return static_cast<std::uint64_t>(blocked >> label_bits) - 1; }
  std::int32_t label_of(Word w) const {
    return filled(w) ? static_cast<std::int32_t>(w & ((Word{1} << label_bits) - 1)) : -1;
  }
  std::int64_t arrival_of(Word w) const {
    return filled(w) ? static_cast<std::int64_t>(w >> label_bits) : -1;
  }
  Word word(std::uint64_t step, std::uint64_t label) const {
    return static_cast<Word>(step << label_bits | label);
  }

  static bool filled(Word w) { return w < blocked; }
  bool settled(Word w) const { return w != empty; }
  bool waits(const Neighbourhood<Word>& n) const {
    if (*n.here != empty) return false;
    for (int k = 0; k < 4; ++k)
      if (filled(n.side(k)) || (corner_threshold > 0 && filled(n.corner(k)))) return true;
    return false;
  }
  Word outside() const { return empty; }
  /// Pairs: the earlier word wins, a barrier neither gives nor takes.
  Word merge(Word mine, Word theirs) const {
    return mine == blocked || theirs == blocked ? mine : std::min(mine, theirs);
  }

  void begin_step(std::uint64_t step) {
    now = word(step, 0);
    moves.resize(speed.size());
    for (std::size_t k = 0; k < speed.size(); ++k) {
      const double t = static_cast<double>(step);
      moves[k] = static_cast<std::uint64_t>(t * speed[k]) > static_cast<std::uint64_t>((t - 1.0) * speed[k]);
    }
  }

  [[gnu::always_inline]] Word next(const Neighbourhood<Word>& n, const CellRandom& random) const {
    if (const Word here = load(n.here); here != empty) return here;
    const Word left = load(n.here - 1), right = load(n.here + 1), below = load(n.below),
               above = load(n.above);
    const Word least = std::min(std::min(left, right), std::min(below, above));
    if (spreads(least)) {
      const Word label = least & label_mask();
      // Whole numbers, not conditions: one branch for all four sides, and nearly always all filled ones are
      // of one label.
      const auto other = [&](Word w) { return unsigned{spreads(w)} & unsigned{(w & label_mask()) != label}; };
      if (speed.empty() && (other(left) | other(right) | other(below) | other(above)) == 0)
        return now | label;
      const Word winner = choose({left, right, below, above}, random);
      if (winner != empty) return now | winner;
    }
    return next_by_corners(n, random);
  }

 private:
  // Filled before this step: a neighbour filled in it is not there yet.
  bool spreads(Word w) const { return w < now; }
  // Another thread may be filling this very cell: a plain move, but no race.
  static Word load(const Word* cell) { return __atomic_load_n(cell, __ATOMIC_RELAXED); }
  Word label_mask() const { return static_cast<Word>((Word{1} << label_bits) - 1); }

  [[gnu::noinline]] Word next_by_corners(const Neighbourhood<Word>& n, const CellRandom& random) const {
    Word corner[4] = {load(n.below - 1), load(n.below + 1), load(n.above - 1), load(n.above + 1)};
    if (!spreads(std::min(std::min(corner[0], corner[1]), std::min(corner[2], corner[3])))) return empty;
    const auto word = random.words(corner_purpose);
    for (std::size_t k = 0; k < 4; ++k)
      if (word[k] >= corner_threshold) corner[k] = empty;
    const Word winner = choose(corner, random);
    return winner == empty ? empty : now | winner;
  }

  // The winning label among the filled candidates, or `empty` when none may spread now.
  Word choose(const Word (&candidates)[4], const CellRandom& random) const {
    Word winner = empty;
    std::uint32_t winning = 0;
    for (const Word w : candidates) {
      if (!spreads(w)) continue;
      const Word label = w & label_mask();
      if (label == winner || (!moves.empty() && !moves[label])) continue;
      if (winner == empty) {
        winner = label;
        continue;
      }
      if (winning == 0) winning = draw(winner, random);
      const std::uint32_t drawn = draw(label, random);
      if (drawn < winning || (drawn == winning && label < winner)) {
        winner = label;
        winning = drawn;
      }
    }
    return winner;
  }

  static std::uint32_t draw(Word label, const CellRandom& random) {
    return random.words(tie_purpose, static_cast<std::uint32_t>(label))[0] | 1u;
  }
};

}  // namespace verdigris
