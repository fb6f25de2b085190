#include "verdigris/automaton/alarms.hpp"

#include <gtest/gtest.h>

using namespace verdigris;

namespace {

std::vector<std::uint32_t> taken(Alarms& alarms) {
  std::vector<std::uint32_t> slots;
  alarms.take([&](std::uint32_t slot) { slots.push_back(slot); });
  return slots;
}

using Slots = std::vector<std::uint32_t>;

TEST(Alarms, GoOffInTheirStepInTheOrderInWhichTheyWereSet) {
  Alarms alarms;
  alarms.set(7, 2);
  alarms.set(3, 0);
  alarms.set(5, 2);
  EXPECT_EQ(taken(alarms), Slots{3});
  alarms.set(9, 1);  // the step of the first two
  EXPECT_EQ(taken(alarms), Slots{});
  EXPECT_TRUE(alarms.any([](std::uint32_t slot) { return slot == 5; }));
  EXPECT_FALSE(alarms.any([](std::uint32_t slot) { return slot == 3; }));
  EXPECT_EQ(taken(alarms), (Slots{7, 5, 9}));
  EXPECT_EQ(taken(alarms), Slots{});
  EXPECT_FALSE(alarms.any([](std::uint32_t) { return true; }));
}

// However far ahead they are, steps without alarms take neither memory nor time.
TEST(Alarms, CostWhatTheyAreNotHowFarAheadTheyAre) {
  Alarms alarms;
  alarms.set(1, 1'000'000'000'000);
  alarms.set(2, 1);
  EXPECT_LT(alarms.bytes(), 1000u);
  EXPECT_EQ(taken(alarms), Slots{});
  EXPECT_EQ(taken(alarms), Slots{2});
  EXPECT_TRUE(alarms.any([](std::uint32_t slot) { return slot == 1; }));
}

}  // namespace
