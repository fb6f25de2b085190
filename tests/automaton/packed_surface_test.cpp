#include "verdigris/automaton/packed_surface.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "shapes.hpp"
#include "verdigris/automaton/bit_sources.hpp"

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

TEST(BitSources, GathersNearAndFarGhosts) {
  constexpr std::uint32_t bits = 1u << 22;
  std::mt19937 engine(4);
  // Without ghosts; in one window; in 16 windows exactly; one window too many; all over the state.
  std::vector<std::vector<std::uint32_t>> patches(6);
  for (int k = 0; k < 100; ++k) patches[1].push_back(70'000 + engine() % 4096);
  for (std::uint32_t k = 0; k < 16; ++k) {
    patches[2].push_back(100'000 * k);
    patches[2].push_back(100'000 * k + 4095);
  }
  patches[3] = patches[2];
  patches[3].push_back(4096);
  for (int k = 0; k < 1000; ++k) patches[4].push_back(engine() % bits);
  patches[5] = patches[1];
  BitSources sources;
  for (const auto& patch : patches) sources.add_patch(patch);
  ASSERT_EQ(sources.patch_count(), patches.size());

  const auto state = random_words(bits / 64, 5);
  std::vector<std::uint64_t> stream(sources.begin(patches.size()) / 64 + 1, 0);
  sources.gather(3, 6, state.data(), stream.data());
  sources.gather(0, 3, state.data(), stream.data());
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t k = 0; k < patches[p].size(); ++k)
      ASSERT_EQ(bit(stream, sources.begin(p) + static_cast<std::uint32_t>(k)), bit(state, patches[p][k]))
          << p << ", " << k;
}

// Where the stream's bits of a patch come to lie: the ghosts as they are laid around the owned cells, bit by
// bit.
std::vector<std::uint64_t> laid_ghosts(const PackedSurface& cells, std::size_t p,
                                       const std::vector<std::uint64_t>& stream) {
  const std::uint32_t first = cells.sources().begin(p);
  std::vector<std::uint64_t> copy(cells.copy_words(), 0);
  const PackedSurface::Group* group = cells.groups(p);
  const auto turned = [&](std::uint32_t byte, unsigned by, unsigned at) {
    return std::uint64_t{bit(stream, first + 8 * byte + (at + 64 - by) % 64)} << at;
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
    std::uint32_t from = first + run.bit;
    for (unsigned at = 0; at < 64; ++at)
      if (run.mask >> at & 1)
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
             {shapes::cube(1), 0.004},               // several words wide, sources far away
             {shapes::square(1), 0.02},              // boundaries
             {shapes::random_plane(9, 40, 2), 1.0},  // no two frames agree
             {shapes::torus(3, 1, 400, 3), 0.02},    // slivers: rows with long runs of ghosts
             {two_long_slivers(), 1.0}};             // more ghosts than a Group can tell of
  std::size_t inside = 0, groups = 0, loose = 0;
  for (const auto& [mesh, h] : all) {
    const Surface s = make_surface(mesh, {.cell_size = h});
    const PackedSurface cells(s);
    auto state = random_words(cells.word_count() + 8, 1);
    state[0] = 0;
    std::vector<std::uint64_t> stream(cells.sources().begin(cells.patch_count()) / 64 + 3, 0);
    cells.sources().gather(0, cells.patch_count(), state.data(), stream.data());
    std::vector<std::uint32_t> source_of(s.slot_count(), 0);
    s.links().for_each([&](std::uint32_t source, auto ghosts) {
      for (const std::uint32_t ghost : ghosts) source_of[ghost] = cells.bit_of(s, source);
    });

    std::vector<std::uint64_t> owned(cells.word_count(), 0);
    for (std::size_t p = 0; p < cells.patch_count(); ++p) {
      cells.for_owned_words(p, [&](std::uint32_t word, std::uint64_t mask) { owned[word] = mask; });
      const auto copy = laid_ghosts(cells, p, stream);
      for (std::uint32_t r = s.row_begin(p); r < s.row_end(p); ++r)
        for (std::uint32_t slot = s.rows()[r].begin; slot < s.rows().data()[r + 1].begin; ++slot) {
          const std::uint32_t at = cells.bit_of(s, slot), word = at / 64;
          const bool is_owned = s.is_owned(slot);
          ASSERT_EQ(bit(owned, at), is_owned);
          if (is_owned) continue;
          const std::uint32_t laid = in_copy(cells, p, word - cells.patch(p).word_begin);
          ASSERT_EQ(copy[laid] >> (at % 64) & 1, bit(state, source_of[slot]))
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
