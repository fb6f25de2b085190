#include <gtest/gtest.h>

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

TEST(Links, NoneAtAll) {
  const Links links(100, {});
  EXPECT_TRUE(links.targets(50).empty());
  EXPECT_EQ(links.size(), 0u);
}

}  // namespace
