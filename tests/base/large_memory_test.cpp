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
  // It may clear what it is given, and nothing beside that.
  for (const std::size_t skipped : {0u, 1u, 4095u}) {
    std::vector<unsigned char> bytes(9 << 20, 1);
    const auto end = bytes.end() - 4096;
    ready_memory(bytes.data() + skipped, bytes.size() - skipped - 4096);
    const auto one = [](unsigned char b) { return b == 1; };
    EXPECT_TRUE(std::all_of(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(skipped), one));
    EXPECT_TRUE(std::all_of(end, bytes.end(), one));
    EXPECT_TRUE(std::all_of(bytes.begin(), bytes.end(), [](unsigned char b) { return b <= 1; }));
  }
}

}  // namespace
