#include "verdigris/base/large_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

using namespace verdigris;

namespace {

TEST(LargeMemory, HoldsWhatItIsGiven) {
  for (const std::size_t count : {0u, 1u, 1000u, 5'000'001u}) {
    const std::vector<std::uint32_t> same = large_vector(count, std::uint32_t{7});
    ASSERT_EQ(same.size(), count);
    EXPECT_TRUE(std::all_of(same.begin(), same.end(), [](std::uint32_t x) { return x == 7; }));

    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    numbers.reserve(count + 100);
    const std::vector<std::uint32_t> copy = large_copy(numbers);
    EXPECT_EQ(copy, numbers);
    EXPECT_EQ(copy.capacity(), count);
  }
}

TEST(LargeMemory, IsReadiedAgainAfterUse) {
  // What the heap hands out once more, and memory of any alignment.
  for (int turn = 0; turn < 3; ++turn) {
    std::vector<std::uint64_t> many;
    reserve_large(many, std::size_t{3} << 20);
    many.resize(std::size_t{3} << 20, 1);
    EXPECT_EQ(std::accumulate(many.begin(), many.end(), std::uint64_t{0}), many.size());
  }
  std::vector<unsigned char> bytes(9 << 20);
  for (const std::size_t skipped : {0, 1, 4095}) ready_memory(bytes.data() + skipped, bytes.size() - skipped);
}

}  // namespace
