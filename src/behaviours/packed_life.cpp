// Bit-sliced counting: the neighbours of 64 cells are added in a few logical operations on whole words.

#include "verdigris/behaviours/packed_life.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <utility>

#include "verdigris/base/error.hpp"

#if defined(__AVX512F__) || defined(__BMI2__)
#include <immintrin.h>
#endif
// Vectors wider than the machine's are passed between functions of this file only: no ABI is at stake.
#pragma GCC diagnostic ignored "-Wpsabi"
#ifdef __AVX512F__
// g++ 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace verdigris {

namespace {

// Eight rows of one word column; compilers split it where vectors are shorter.
typedef std::uint64_t Rows __attribute__((vector_size(64)));  // NOLINT(modernize-use-using)
constexpr std::size_t lanes = 8;
// Words before and after a patch's copy that may be read.
constexpr std::size_t margin = 2 * lanes;

Rows load(const std::uint64_t* words) {
  Rows rows;
  std::memcpy(&rows, words, sizeof rows);
  return rows;
}

// Bits of `bits` laid where `mask` has its ones, lowest first.
std::uint64_t deposit(std::uint64_t bits, std::uint64_t mask) {
#ifdef __BMI2__
  return _pdep_u64(bits, mask);
#else
  std::uint64_t laid = 0;
  for (; mask != 0; mask &= mask - 1, bits >>= 1) laid |= (bits & 1) * (mask & -mask);
  return laid;
#endif
}

void store(std::uint64_t* words, Rows rows) {
  std::memcpy(words, &rows, sizeof rows);
}

// The owned bits of eight words. Shifts stay below 64: beyond it they mean nothing.
Rows owned_bits(const PackedSurface::Bits* bits) {
  typedef std::uint32_t Packed __attribute__((vector_size(32)));  // NOLINT(modernize-use-using)
  static_assert(sizeof(PackedSurface::Bits) == 4 && std::endian::native == std::endian::little);
  Packed packed;
  std::memcpy(&packed, bits, sizeof packed);
  const Rows all = __builtin_convertvector(packed, Rows);
  const Rows begin = all >> 16 & 255, count = (all >> 24) - begin;
  return ((~Rows{} >> ((64 - count) & 63)) << (begin & 63)) & reinterpret_cast<Rows>(count != 0);
}

// Whether eight words are all inside a patch: owned from end to end.
bool inside(const PackedSurface::Bits* bits) {
  constexpr std::uint64_t both = 0x4000400040004000;  // {0, 64, 0, 64} twice
  std::uint64_t four[4];
  std::memcpy(four, bits, sizeof four);
  return ((four[0] ^ both) | (four[1] ^ both) | (four[2] ^ both) | (four[3] ^ both)) == 0;
}

// Three cells added up: two binary digits.
struct Sum {
  Rows ones, twos;
};
Sum add(Rows a, Rows b, Rows c) {
  return {a ^ b ^ c, (a & b) | (c & (a ^ b))};
}

// Cells alive next: for each sum that means something, the cells that have it. The sum is over a cell and its
// neighbours, as three sums of a row each; so a live cell's own one is in it.
Rows decide(const Sum& below, const Sum& here, const Sum& above, Rows centre, const LifeRule& rule) {
  const Sum ones = add(below.ones, here.ones, above.ones), twos = add(below.twos, here.twos, above.twos);
  const Rows carry = ones.twos & twos.ones;
  const Rows digit[4] = {ones.ones, ones.twos ^ twos.ones, twos.twos ^ carry, twos.twos & carry};
  Rows born{}, stays{};
  for (unsigned sum = 0; sum <= 9; ++sum) {
    const bool b = (rule.birth >> sum & 1) != 0, s = sum > 0 && (rule.survival >> (sum - 1) & 1) != 0;
    if (!b && !s) continue;
    Rows has = (sum & 8) != 0 ? digit[3] : ~digit[3];
    for (unsigned k = 0; k < 3; ++k) has &= (sum >> k & 1) != 0 ? digit[k] : ~digit[k];
    if (b) born |= has;
    if (s) stays |= has;
  }
  return (born & ~centre) | (stays & centre);
}

}  // namespace

PackedLife::PackedLife(const PackedSurface& cells, const LifeRule& rule)
    : cells_(cells),
      rule_(rule),
      state_(cells.word_count() + lanes, 0),
      ghosts_(cells.patch(cells.patch_count()).ghost_begin / 64 + 3, 0) {}

void PackedLife::set(std::uint32_t bit, bool alive) {
  const std::uint64_t one = std::uint64_t{1} << (bit & 63);
  if (alive)
    state_[bit >> 6] |= one & cells_.bits()[bit >> 6].owned();
  else
    state_[bit >> 6] &= ~one;
}

void PackedLife::fill(double density, std::uint64_t seed) {
  constexpr std::uint32_t filling = 0x4C494645;
  const std::uint64_t limit = threshold(density);
  tbb::parallel_for(std::size_t{0}, cells_.word_count(), [&](std::size_t word) {
    std::uint64_t alive = 0;
    for (std::uint32_t block = 0; block < 16; ++block) {
      const auto words = CellRandom(seed, 0, static_cast<std::uint32_t>(word)).words(filling, block);
      for (unsigned k = 0; k < 4; ++k) alive |= std::uint64_t{words[k] < limit} << (4 * block + k);
    }
    state_[word] = alive & cells_.bits()[word].owned();
  });
}

void PackedLife::restore(std::vector<std::uint64_t> state, std::uint64_t steps) {
  bool good = state.size() == state_.size();
  for (std::size_t word = 0; good && word < state.size(); ++word)
    good = (state[word] & ~(word < cells_.word_count() ? cells_.bits()[word].owned() : 0)) == 0;
  if (!good) throw InputError("cells", "they are not of this surface", "start again without this checkpoint");
  state_ = std::move(state);
  steps_ = steps;
}

std::uint64_t PackedLife::population() const {
  std::uint64_t alive = 0;
  for (const std::uint64_t word : state_) alive += static_cast<std::uint64_t>(std::popcount(word));
  return alive;
}

// The bits of all ghosts of some patches, 16 at a time: patches begin at multiples of 16.
void PackedLife::gather_ghosts(std::size_t first_patch, std::size_t last_patch) {
  const std::uint32_t begin = cells_.patch(first_patch).ghost_begin,
                      end = cells_.patch(last_patch).ghost_begin;
  const std::uint32_t* sources = cells_.ghost_sources();
  auto* out = reinterpret_cast<unsigned char*>(ghosts_.data());
  for (std::uint32_t k = begin; k < end; k += 16) {
    std::uint16_t bits = 0;
#ifdef __AVX512F__
    const __m512i bit = _mm512_loadu_si512(sources + k);
    const __m512i words = _mm512_i32gather_epi32(_mm512_srli_epi32(bit, 5), state_.data(), 4);
    const __m512i one = _mm512_sllv_epi32(_mm512_set1_epi32(1), _mm512_and_si512(bit, _mm512_set1_epi32(31)));
    bits = static_cast<std::uint16_t>(_mm512_test_epi32_mask(words, one));
#else
    for (unsigned j = 0; j < 16; ++j)
      bits = static_cast<std::uint16_t>(bits | static_cast<unsigned>(alive(sources[k + j])) << j);
#endif
    std::memcpy(out + k / 8, &bits, sizeof bits);
  }
}

std::uint64_t PackedLife::advance(std::size_t patch, std::vector<std::uint64_t>& room) {
  const PackedSurface::Patch& p = cells_.patch(patch);
  const std::size_t words = cells_.patch(patch + 1).word_begin - p.word_begin;
  if (words == 0) return 0;
  // A copy of the patch as it was, ghosts laid in.
  std::uint64_t* old = room.data() + margin;
  std::uint64_t* state = state_.data() + p.word_begin;
  const PackedSurface::Bits* bits = cells_.bits() + p.word_begin;
  std::uint64_t ghost = p.ghost_begin;
  const std::uint64_t* stream = ghosts_.data();
  for (std::size_t w = 0; w < words; ++w) {
    if (w + lanes <= words && inside(bits + w)) {
      store(old + w, load(state + w));
      w += lanes - 1;
      continue;
    }
    const std::uint64_t mask = bits[w].ghosts();
    const unsigned shift = ghost & 63;
    // Two words hold the next 64 bits; << 1 first, since a shift by 64 means nothing.
    const std::uint64_t next = stream[ghost >> 6] >> shift | stream[(ghost >> 6) + 1] << 1 << (63 - shift);
    old[w] = state[w] | deposit(next, mask);
    ghost += static_cast<std::uint64_t>(std::popcount(mask));
  }
  std::memset(old + words, 0, margin * sizeof(std::uint64_t));

  // Sums along the rows: a cell and those beside it; with four neighbours, rows above and below count the
  // cell alone.
  const std::size_t stride = room.size() / 3;
  std::uint64_t *ones = old + stride, *twos = ones + stride;
  const auto rows = cells_.column_rows(patch);
  const bool moore = rule_.neighbourhood == LifeNeighbourhood::moore;
  std::size_t column = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    // Words to the left and right; beyond their last row there is nothing that is read.
    const std::size_t left_rows = k > 0 ? rows[k - 1] : 0, right_rows = k + 1 < rows.size() ? rows[k + 1] : 0;
    for (std::size_t row = 0; row < rows[k]; row += lanes) {
      const Rows centre = load(old + column + row);
      Rows left = centre << 1, right = centre >> 1;
      if (row < left_rows) left |= load(old + column - left_rows + row) >> 63;
      if (row < right_rows) right |= load(old + column + rows[k] + row) << 63;
      const Sum sum = add(left, centre, right);
      store(ones + column + row, sum.ones);
      store(twos + column + row, sum.twos);
    }
    column += rows[k];
  }

  std::uint64_t changed = 0;
  column = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const auto sum_at = [&](std::size_t w) { return Sum{load(ones + w), load(twos + w)}; };
    const auto alone = [&](std::size_t w) { return Sum{load(old + w), Rows{}}; };
    // Row 0 of a column is grid row -1: nothing evolves there, nor in the last.
    for (std::size_t row = 1; row + 1 < rows[k]; row += lanes) {
      const std::size_t w = column + row;
      // What was owned before is read from the copy: beyond this patch others are writing.
      const Rows centre = load(old + w), owned = owned_bits(bits + w), before = centre & owned;
      const Rows next = (moore ? decide(sum_at(w - 1), sum_at(w), sum_at(w + 1), centre, rule_)
                               : decide(alone(w - 1), sum_at(w), alone(w + 1), centre, rule_)) &
                        owned;
      const std::size_t some = std::min(lanes, rows[k] - 1 - row);
      const Rows differs = next ^ before;
      if (some == lanes) {
        store(state + w, next);
      } else {
        for (std::size_t lane = 0; lane < some; ++lane) state[w + lane] = next[lane];
      }
      for (std::size_t lane = 0; lane < some; ++lane)
        changed += static_cast<std::uint64_t>(std::popcount(differs[lane]));
    }
    column += rows[k];
  }
  return changed;
}

std::uint64_t PackedLife::step() {
  const std::size_t patches = cells_.patch_count();
  constexpr std::size_t grain = 64;
  // Tasks of whole words of ghost bits would be finer than need be: each writes 16 bits at a time of its own.
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, patches, grain),
      [&](const tbb::blocked_range<std::size_t>& range) { gather_ghosts(range.begin(), range.end()); });
  tbb::enumerable_thread_specific<std::vector<std::uint64_t>> room(
      [&] { return std::vector<std::uint64_t>(3 * (cells_.largest_patch_words() + 3 * margin), 0); });
  const std::uint64_t changed = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, patches, grain), std::uint64_t{0},
      [&](const tbb::blocked_range<std::size_t>& range, std::uint64_t sum) {
        auto& mine = room.local();
        for (std::size_t patch = range.begin(); patch < range.end(); ++patch) sum += advance(patch, mine);
        return sum;
      },
      std::plus<>());
  ++steps_;
  return changed;
}

}  // namespace verdigris
