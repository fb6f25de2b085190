// A front gives the same bits as a full sweep, and any number of threads the same as one.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "growth.hpp"

using namespace growth;

namespace {

struct Case {
  const char* name;
  Mesh mesh;
  double cell_size;
  LinkKind links;
  bool speeds, barrier;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected}) {
    all.push_back({"torus", shapes::torus(3, 1, 20, 12), 0.06, links, false, false});
    all.push_back({"cube, speeds", shapes::cube(1), 0.02, links, true, false});
    all.push_back({"plane, barrier", shapes::random_plane(9, 40, 2), 1.0, links, true, true});
    all.push_back({"few cells a triangle", shapes::torus(3, 1, 90, 40), 0.07, links, false, false});
  }
  return all;
}

template <typename Word>
struct Start {
  VoronoiRule<Word> rule;
  Field<Word> state;
  std::vector<std::uint32_t> sources;
};

template <typename Word>
Start<Word> start(const Surface& s, const Case& c) {
  Start<Word> begin;
  begin.rule.label_bits = 3;
  if (c.speeds) begin.rule.speed = {1.0, 0.5, 0.3, 0.77, 1.0, 1.0, 0.9, 0.25};
  begin.state.assign(s.slot_count(), VoronoiRule<Word>::empty);
  if (c.barrier)
    for (const Row& row : s.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        if (CellRandom(1, 2, slot).words(3)[0] < threshold(0.1))
          begin.state[slot] = VoronoiRule<Word>::blocked;
  for (const Seed& seed : random_seeds(s, 8, 5)) {
    begin.state[seed.slot] = begin.rule.word(0, begin.sources.size());
    begin.sources.push_back(seed.slot);
  }
  return begin;
}

// States of evolving cells only: ghosts follow them.
template <typename Word>
std::vector<Word> cells(const Surface& s, const Field<Word>& state) {
  std::vector<Word> values;
  for (const Row& row : s.rows())
    values.insert(values.end(), state.begin() + row.run_begin, state.begin() + row.run_end);
  return values;
}

TEST(Stepping, AFrontGivesTheBitsOfAFullSweep) {
  for (const Case& c : cases()) {
    const Surface s = make_surface(c.mesh, {.cell_size = c.cell_size, .links = c.links});
    const auto begin = start<std::uint32_t>(s, c);
    SweepStepper<VoronoiRule<std::uint32_t>> sweep(s, begin.rule, begin.state, 11);
    FrontStepper<VoronoiRule<std::uint32_t>> front(s, begin.rule, begin.state, 11, begin.sources);
    // With every cell a candidate at first, as after a restart.
    FrontStepper<VoronoiRule<std::uint32_t>> all(s, begin.rule, begin.state, 11);
    for (int step = 0; step < 2000 && !front.finished(); ++step) {
      const auto a = sweep.step();
      const auto b = front.step();
      const auto d = all.step();
      ASSERT_EQ(a.changed, b.changed) << c.name << ", step " << step;
      ASSERT_EQ(a.changed, d.changed) << c.name << ", step " << step;
      ASSERT_LE(b.visited, a.visited);
      if (step % 10 == 0) {
        ASSERT_EQ(cells(s, sweep.state()), cells(s, front.state())) << c.name << ", step " << step;
      }
    }
    EXPECT_TRUE(front.finished()) << c.name;
    EXPECT_EQ(cells(s, sweep.state()), cells(s, front.state())) << c.name;
    EXPECT_EQ(cells(s, sweep.state()), cells(s, all.state())) << c.name;
    EXPECT_EQ(sweep.step().changed, 0u) << c.name;
  }
}

TEST(Stepping, AnyNumberOfThreadsGivesTheSameBits) {
  const Surface s = make_surface(shapes::torus(3, 1, 60, 40),
                                 {.cell_size = 0.011});  // a million cells: fronts worth sharing
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    SimulationSetup setup{s, 3, random_seeds(s, 500, 3), {}};
    VoronoiGrowth growth(setup, {});
    std::uint64_t visited = 0;
    while (!growth.finished()) visited += growth.step().visited;
    return std::pair{visited, std::pair{growth.labels(), growth.arrivals()}};
  };
  const auto one = run(1);
  EXPECT_EQ(one, run(2));
  EXPECT_EQ(one, run(5));
  // A bounded number of visits for each cell in all, not one each step.
  EXPECT_LT(static_cast<double>(one.first), 1.5 * static_cast<double>(s.owned_count()));
}

TEST(Stepping, WordsOfAnyWidthGiveTheSameResult) {
  const Case c{"torus", shapes::torus(3, 1, 20, 12), 0.06, LinkKind::unfolded, true, true};
  const Surface s = make_surface(c.mesh, {.cell_size = c.cell_size, .links = c.links});
  const auto narrow = start<std::uint32_t>(s, c);
  const auto wide = start<std::uint64_t>(s, c);
  FrontStepper<VoronoiRule<std::uint32_t>> a(s, narrow.rule, narrow.state, 11, narrow.sources);
  FrontStepper<VoronoiRule<std::uint64_t>> b(s, wide.rule, wide.state, 11, wide.sources);
  while (!a.finished()) {
    a.step();
    b.step();
  }
  for (const Row& row : s.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
      ASSERT_EQ(a.behaviour().label_of(a.state()[slot]), b.behaviour().label_of(b.state()[slot]));
      ASSERT_EQ(a.behaviour().arrival_of(a.state()[slot]), b.behaviour().arrival_of(b.state()[slot]));
    }
}

TEST(LongStepping, WordsWidenByThemselves) {
  // 2^19 + 1 labels leave 12 bits for the arrival: 4094 steps, fewer than this strip is long.
  Mesh strip{
      {{0, 0, 0}, {10000, 0, 0}, {10000, 120, 0}, {0, 120, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}, {}};
  const Surface s = make_surface(strip, {.cell_size = 1.0});
  SimulationSetup setup{s, 3, {}, {}};
  each_owned(s, [&](std::uint32_t slot) {
    if (s.position(slot).x < 4400.0) setup.seeds.push_back({slot, 1.0});
  });
  ASSERT_GT(setup.seeds.size(), std::size_t{1} << 19);
  ASSERT_LE(setup.seeds.size(), std::size_t{1} << 20);
  VoronoiGrowth growth(setup, {});
  while (!growth.finished()) growth.step();
  EXPECT_GT(growth.steps(), 5000u);
  const auto arrivals = growth.arrivals();
  each_owned(s, [&](std::uint32_t slot) {
    const double x = s.position(slot).x;
    ASSERT_GE(arrivals[slot], 0);
    if (x > 4600.0) {
      ASSERT_NEAR(arrivals[slot], x - 4400.0, 0.05 * (x - 4400.0) + 3.0);
    }
  });
}

}  // namespace
