#include "verdigris/automaton/packed_surface.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "shapes.hpp"
#include "verdigris/automaton/sent_bits.hpp"
#include "verdigris/surface/ghost_values.hpp"

using namespace verdigris;

namespace {

bool bit(const std::vector<std::uint64_t>& words, std::uint32_t k) {
  return words[k / 64] >> (k % 64) & 1;
}

std::vector<std::uint64_t> random_words(std::size_t count, unsigned seed) {
  std::mt19937_64 engine(seed);
  std::vector<std::uint64_t> words(count);
  for (std::uint64_t& word : words) word = engine();
  return words;
}

TEST(SentBits, GathersNumbersOfAnyWidth) {
  std::mt19937 engine(4);
  // Bits below a power of two, the last below it among them; nothing; one more than two blocks.
  const std::pair<std::uint32_t, std::size_t> all[] = {
      {1u << 12, 100},      {1, 0},         {1u << 16, 40},      {1u << 22, 70}, {1u << 12, 33},
      {(1u << 12) + 1, 16}, {1u << 22, 16}, {(1u << 16) + 1, 5}, {64, 1}};
  std::vector<std::vector<std::uint32_t>> patches;
  SentBits sent;
  for (const auto& [bits, count] : all) {
    std::vector<std::uint32_t> patch(count);
    for (std::uint32_t& number : patch) number = static_cast<std::uint32_t>(engine()) % bits;
    if (count > 0) patch[count / 2] = bits - 1;
    sent.add_patch(patch);
    patches.push_back(patch);
  }
  sent.settle();
  ASSERT_EQ(sent.patch_count(), patches.size());

  std::vector<std::uint64_t> stream(sent.begin(patches.size()) / 64 + 1, 0);
  const auto words_of = [&](std::size_t p) {
    return random_words((1u << 22) / 64 + 1, static_cast<unsigned>(p));
  };
  // In no order: each writes its own part only.
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const std::size_t p = (4 * k + 3) % patches.size();
    sent.gather(p, words_of(p).data(), stream.data());
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto words = words_of(p);
    EXPECT_EQ(sent.begin(p) % 16, 0u);
    for (std::size_t k = 0; k < patches[p].size(); ++k)
      ASSERT_EQ(bit(stream, sent.begin(p) + static_cast<std::uint32_t>(k)), bit(words, patches[p][k]))
          << p << ", " << k;
  }
}

// Where the stream's bits of a patch come to lie: the ghosts as they are laid around the owned cells, bit by
// bit.
std::vector<std::uint64_t> laid_ghosts(const PackedSurface& cells, std::size_t p,
                                       const std::vector<std::uint64_t>& stream) {
  std::vector<std::uint64_t> copy(cells.copy_words(), 0);
  const PackedSurface::Group* group = cells.groups(p);
  const auto turned = [&](std::uint32_t byte, unsigned by, unsigned at) {
    return std::uint64_t{bit(stream, 8 * byte + (at + 64 - by) % 64)} << at;
  };
  std::uint32_t column_at = 0;
  for (const PackedSurface::Column& column : cells.columns(p)) {
    for (std::uint32_t g = column.inside; g < column.groups(); ++g, ++group)
      for (std::uint32_t k = 0; k < 8; ++k)
        for (unsigned at = 0; at < 64; ++at) {
          std::uint64_t& word = copy[column_at + 8 + 8 * g + k];
          if (at < group->owned_begin[k]) word |= turned(group->left_byte, group->left_turn[k], at);
          if (at >= group->owned_end[k]) word |= turned(group->right_byte, group->right_turn[k], at);
        }
    column_at += column.pitch();
  }
  for (const PackedSurface::LooseRun& run : cells.loose_runs(p)) {
    std::uint32_t from = run.bit;
    for (unsigned at = 0; at < 64; ++at)
      if (run.mask() >> at & 1)
        copy[run.at] = (copy[run.at] & ~(std::uint64_t{1} << at)) | std::uint64_t{bit(stream, from++)} << at;
  }
  return copy;
}

Mesh two_long_slivers() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {300000, 0, 0}, {150000, 4.2, 0}, {150000, -4.2, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

// Word of the copy of a patch in which word `word` of the patch stands.
std::uint32_t in_copy(const PackedSurface& cells, std::size_t p, std::uint32_t word) {
  std::uint32_t at = 7;
  for (const PackedSurface::Column& column : cells.columns(p)) {
    if (word < column.rows) break;
    word -= column.rows;
    at += column.pitch();
  }
  return at + word;
}

TEST(PackedSurface, LaysEveryGhostBesideItsCells) {
  const struct {
    Mesh mesh;
    double cell_size;
  } all[] = {{shapes::torus(3, 1, 30, 20), 0.03},    // about 20 rows, one word wide
             {shapes::cube(1), 0.004},               // several words wide
             {shapes::square(1), 0.02},              // boundaries
             {shapes::random_plane(9, 40, 2), 1.0},  // no two frames agree
             {shapes::torus(3, 1, 400, 3), 0.02},    // slivers: rows with long runs of ghosts
             {two_long_slivers(), 1.0}};             // patches of more than 2^16 bits
  std::size_t inside = 0, groups = 0, loose = 0;
  for (const auto& [mesh, h] : all) {
    const Surface s = make_surface(mesh, {.cell_size = h});
    const PackedSurface cells(s);
    const auto random = random_words(cells.word_count(), 1);
    std::vector<std::uint64_t> owned(cells.word_count(), 0), state(cells.word_count() + 8, 0);
    for (std::size_t p = 0; p < cells.patch_count(); ++p)
      cells.for_owned_words(p, [&](std::uint32_t word, std::uint64_t mask) {
        owned[word] = mask;
        state[word] = random[word] & mask;
      });
    std::vector<std::uint64_t> stream(cells.sent().begin(cells.patch_count()) / 64 + 3, 0);
    for (std::size_t p = 0; p < cells.patch_count(); ++p)
      cells.sent().gather(p, state.data() + cells.word_begin(p), stream.data());
    constexpr std::uint32_t nothing = 0xFFFFFFFFu;
    const std::vector<std::uint32_t> source_of = ghost_sources(s, nothing);

    for (std::size_t p = 0; p < cells.patch_count(); ++p) {
      const auto copy = laid_ghosts(cells, p, stream);
      for (std::uint32_t r = s.row_begin(p); r < s.row_end(p); ++r)
        for (std::uint32_t slot = s.rows()[r].begin; slot < s.rows().data()[r + 1].begin; ++slot) {
          const std::uint32_t at = cells.bit_of(s, slot), word = at / 64;
          const bool is_owned = s.is_owned(slot);
          ASSERT_EQ(bit(owned, at), is_owned);
          if (is_owned) continue;
          const std::uint32_t laid = in_copy(cells, p, word - cells.word_begin(p));
          const std::uint32_t source = source_of[slot];
          ASSERT_EQ(copy[laid] >> (at % 64) & 1, source != nothing && bit(state, cells.bit_of(s, source)))
              << p << ", " << r << ", " << slot;
        }
      for (const auto& column : cells.columns(p)) {
        inside += column.inside;
        groups += column.groups() - column.inside;
      }
      loose += cells.loose_runs(p).size();
    }
    std::size_t count = 0;
    for (const std::uint64_t word : owned) count += static_cast<std::size_t>(std::popcount(word));
    EXPECT_EQ(count, s.owned_count());
    EXPECT_EQ(count, cells.owned_count());
  }
  EXPECT_GT(inside, 0u);
  EXPECT_GT(groups, 0u);
  EXPECT_GT(loose, 0u);
}

TEST(PackedSurface, TakesUnfoldedLinksOnly) {
  const Surface s = make_surface(shapes::square(1), {.cell_size = 0.1, .links = LinkKind::projected});
  EXPECT_THROW(PackedSurface{s}, std::invalid_argument);
}

}  // namespace
