#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "verdigris/surface/links.hpp"

using verdigris::Links;

namespace {

std::uint64_t pair(std::uint64_t source, std::uint64_t target) {
  return source << 32 | target;
}

TEST(Links, FindTargetsOfEachSource) {
  const std::vector<std::uint64_t> pairs{pair(0, 7),  pair(63, 1),  pair(63, 2),
                                         pair(64, 3), pair(200, 4), pair(200, 5)};
  const Links links(256, pairs);
  EXPECT_EQ(links.size(), 6u);
  const auto targets = [&](std::uint32_t s) {
    return std::vector<std::uint32_t>(links.targets(s).begin(), links.targets(s).end());
  };
  EXPECT_EQ(targets(0), std::vector<std::uint32_t>{7});
  EXPECT_EQ(targets(63), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(targets(64), std::vector<std::uint32_t>{3});
  EXPECT_EQ(targets(200), (std::vector<std::uint32_t>{4, 5}));
  EXPECT_TRUE(targets(1).empty());
  EXPECT_TRUE(targets(255).empty());
  std::vector<std::uint64_t> seen;
  links.for_each([&](std::uint32_t s, auto all) {
    for (auto t : all) seen.push_back(pair(s, t));
  });
  EXPECT_EQ(seen, pairs);
}

TEST(Links, ManySourcesAndTargets) {
  // Every slot of some words a source; sources of one target and of hundreds; words without any.
  std::mt19937 engine(3);
  std::vector<std::uint64_t> pairs;
  constexpr std::uint32_t slots = 5000;
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    const bool dense = slot / 500 % 3 == 0, none = slot / 500 % 3 == 1;
    if (none || (!dense && engine() % 5 != 0)) continue;
    const auto count = static_cast<std::uint32_t>(1 + engine() % (engine() % 50 == 0 ? 300 : 3));
    for (std::uint32_t k = 0; k < count; ++k) pairs.push_back(pair(slot, 10'000 + k));
  }
  const Links links(slots, pairs);
  std::vector<std::uint64_t> one_by_one, all, half;
  for (std::uint32_t slot = 0; slot < slots; ++slot)
    for (const std::uint32_t target : links.targets(slot)) one_by_one.push_back(pair(slot, target));
  const auto put_into = [](std::vector<std::uint64_t>& seen) {
    return [&seen](std::uint32_t source, auto targets) {
      for (const std::uint32_t target : targets) seen.push_back(pair(source, target));
    };
  };
  links.for_each(put_into(all));
  links.for_each_between(40, links.word_count(), put_into(half));
  EXPECT_EQ(one_by_one, pairs);
  EXPECT_EQ(all, pairs);
  const auto middle = std::lower_bound(pairs.begin(), pairs.end(), pair(40 * 64, 0));
  EXPECT_EQ(half, std::vector<std::uint64_t>(middle, pairs.end()));
}

TEST(Links, NoneAtAll) {
  const Links links(100, {});
  EXPECT_TRUE(links.targets(50).empty());
  EXPECT_EQ(links.size(), 0u);
}

}  // namespace
