#include <gtest/gtest.h>

#include <set>

#include "verdigris/automaton/random.hpp"

using namespace verdigris;

namespace {

TEST(CellRandom, DependsOnEveryPartOfItsKeyAndNothingElse) {
  std::set<std::uint32_t> words;
  for (const std::uint64_t seed : {0ull, 1ull, 1ull << 40})
    for (const std::uint64_t step : {0ull, 1ull, 1ull << 33})
      for (const std::uint32_t cell : {0u, 1u, 77u})
        for (const std::uint32_t purpose : {1u, 2u})
          for (const std::uint32_t block : {0u, 1u})
            for (const std::uint32_t w : CellRandom(seed, step, cell).words(purpose, block)) words.insert(w);
  EXPECT_EQ(words.size(), 3u * 3 * 3 * 2 * 2 * 4);
  EXPECT_EQ(CellRandom(5, 6, 7).words(8), CellRandom(5, 6, 7).words(8));
}

TEST(CellRandom, KeepsItsNumbersForEver) {
  // Runs are repeated from their files years later: these words must never change.
  const auto w = CellRandom(7, 1, 12345).words(0x564f5201);
  EXPECT_EQ(w[0], 3225874662u);
}

TEST(CellRandom, IsUniform) {
  double sum = 0.0, squares = 0.0;
  std::uint32_t below = 0;
  const int n = 100000;
  for (int cell = 0; cell < n; ++cell) {
    const auto words = CellRandom(3, 9, static_cast<std::uint32_t>(cell)).words(1);
    const double u = words[0] / 4294967296.0;
    sum += u;
    squares += u * u;
    below += words[1] < threshold(0.2071);
  }
  EXPECT_NEAR(sum / n, 0.5, 0.004);
  EXPECT_NEAR(squares / n, 1.0 / 3.0, 0.004);
  EXPECT_NEAR(below / static_cast<double>(n), 0.2071, 0.005);
}

TEST(Threshold, CertainAndImpossible) {
  EXPECT_EQ(threshold(0.0), 0u);
  EXPECT_EQ(threshold(-1.0), 0u);
  EXPECT_EQ(threshold(1.0), std::uint64_t{1} << 32);
  EXPECT_EQ(threshold(2.0), std::uint64_t{1} << 32);
  EXPECT_EQ(threshold(0.5), std::uint64_t{1} << 31);
}

}  // namespace
