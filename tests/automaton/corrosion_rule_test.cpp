// The rule of corrosion against what the paper says of it.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <glm/geometric.hpp>
#include <numeric>

#include "corrosion.hpp"
#include "verdigris/automaton/link_turns.hpp"
#include "verdigris/base/error.hpp"

using namespace growth;

namespace {

// Squares cut along one diagonal or, at random, the other: flat, and all grids line up.
Mesh sheet(int squares, bool random) {
  const double side = 20.0 / std::sqrt(2.0);
  Mesh m = shapes::grid(squares, squares, false, false,
                        [&](int i, int j) { return glm::dvec3(i * side, j * side, 0.0); });
  for (std::size_t q = 0; q < m.triangles.size(); q += 2)
    if (random && CellRandom(1, 0, static_cast<std::uint32_t>(q)).words(1)[0] % 2 == 0) {
      const auto a = m.triangles[q][0], b = m.triangles[q][1], c = m.triangles[q][2],
                 d = m.triangles[q + 1][2];
      m.triangles[q] = {a, b, d};
      m.triangles[q + 1] = {b, c, d};
    }
  return m;
}

CorrosionForces hardly() {
  // Ripe from the first step, but overcoming anyone is a rare stroke of luck.
  return {.luck = 1.0,
          .attack_age = 1,
          .reach_age = 10,
          .defence = 0.9999,
          .strong_defence = 0.9999,
          .support = 0.0};
}

TEST(CorrosionRule, NeverAttacksMoreThanSeven) {
  for (const Mesh& mesh : {shapes::square(60), sheet(4, false), sheet(4, true)}) {
    const Surface s = make_surface(mesh, {.cell_size = 1.0});
    const CorrosionRule rule(hardly());
    FrontStepper<CorrosionRule> front(s, rule, corrosion_start(s, rule, 0.0, 400, 3), 5);
    int most = 0;
    for (int step = 0; step < 40; ++step) {
      front.step();
      const auto attacks = attacks_by(s, front.state());
      each_owned(s, [&](std::uint32_t slot) {
        ASSERT_LE(attacks[slot], 7);
        most = std::max(most, attacks[slot]);
        const Word word = front.state()[slot];
        if (CorrosionRule::corroded(word) && (word & CorrosionRule::done_bit) == 0) {
          ASSERT_LE(std::popcount(word & 0xFFu), 7);
        }
      });
    }
    EXPECT_EQ(most, 7);
  }
}

TEST(CorrosionRule, AttacksMoreWithAge) {
  const Surface s = make_surface(shapes::plain(20), {.cell_size = 1.0});
  const CorrosionRule rule(hardly());
  Field<Word> state = corrosion_start(s, rule, 0.0, 1, 3);
  FrontStepper<CorrosionRule> front(s, rule, state, 5);
  for (std::uint64_t step = 1; step <= 14; ++step) {
    front.step();
    std::uint32_t attacked = 0;
    each_owned(s, [&](std::uint32_t slot) {
      if (CorrosionRule::corroded(front.state()[slot]))
        attacked = static_cast<std::uint32_t>(std::popcount(front.state()[slot] & 0xFFu));
    });
    // Drawn in `step`, carried out a step later: 1 + 6 age / 10, at most 7.
    EXPECT_EQ(attacked, 1 + std::min<std::uint64_t>(6, 6 * (step + 1) / 10)) << step;
    EXPECT_EQ(attacked, rule.attacked(8, step + 1));
  }
  for (std::uint32_t valid = 1; valid <= 8; ++valid) {
    EXPECT_EQ(rule.attacked(valid, 0), 1u);
    EXPECT_EQ(rule.attacked(valid, 1000), std::min(valid, 7u));
  }
}

TEST(CorrosionRule, PrefersSidesToCornersTwoToOne) {
  CorrosionForces forces = hardly();
  forces.reach_age = 1'000'000;  // always one
  const Surface s = make_surface(shapes::plain(60), {.cell_size = 1.0});
  const CorrosionRule rule(forces);
  SweepStepper<CorrosionRule> sweep(s, rule, corrosion_start(s, rule, 0.0, 60, 3), 5);
  std::array<int, 8> drawn{};
  for (int step = 0; step < 400; ++step) {
    sweep.step();
    each_owned(s, [&](std::uint32_t slot) {
      for (unsigned k = 0; k < 8; ++k) drawn[k] += static_cast<int>(sweep.state()[slot] >> k & 1u);
    });
  }
  const double all = std::accumulate(drawn.begin(), drawn.end(), 0.0);
  for (unsigned k = 0; k < 8; ++k) EXPECT_NEAR(drawn[k] / all, k % 2 == 0 ? 2.0 / 12 : 1.0 / 12, 0.01) << k;
}

TEST(CorrosionRule, WithoutDefenceAllThatIsAttackedFalls) {
  for (const Mesh& mesh : {shapes::torus(3, 1, 20, 12), sheet(4, true)}) {
    const Surface s = make_surface(mesh, {.cell_size = mesh.positions.size() > 100 ? 0.06 : 1.0});
    const CorrosionRule rule({.attack = 0.001, .defence = 0.0, .strong_defence = 0.0, .support = 0.0});
    FrontStepper<CorrosionRule> front(s, rule, corrosion_start(s, rule, 0.5, 5, 3), 5);
    std::size_t fallen = 0;
    for (int step = 0; step < 60; ++step) {
      const Field<Word> before = front.state();
      front.step();
      for (const Row& row : s.rows())
        for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
          if (!CorrosionRule::sound(before[slot])) continue;
          const Row *below = &row - 1, *above = &row + 1;
          const std::uint32_t x = slot - row.base, b = below->base + x, a = above->base + x;
          const std::uint32_t near[8] = {slot + 1, a + 1, a, a - 1, slot - 1, b - 1, b, b + 1};
          bool attacked = false;
          for (unsigned k = 0; k < 8; ++k)
            attacked = attacked || (before[near[k]] >> ((k + 4) % 8) & 1u) != 0;
          ASSERT_EQ(CorrosionRule::corroded(front.state()[slot]), attacked);
          fallen += attacked;
        }
    }
    EXPECT_GT(fallen, 500u);
  }
}

TEST(CorrosionRule, DirectionsComeTurnedOverEdges) {
  // The grids of a square's halves are half a turn apart, on sheets they are quarter turns apart.
  const Surface s = make_surface(shapes::square(20), {.cell_size = 1.0});
  for (const std::uint8_t turn : link_turns(s)) EXPECT_EQ(turn, 4);
  std::array<int, 8> seen{};
  for (const std::uint8_t turn : link_turns(make_surface(sheet(4, true), {.cell_size = 1.0}))) ++seen[turn];
  for (unsigned k = 0; k < 8; ++k) EXPECT_EQ(seen[k] > 0, k % 2 == 0) << k;
  // There and back again is no turn, on any surface.
  const Surface torus = make_surface(shapes::torus(3, 1, 20, 12), {.cell_size = 0.1});
  for (std::uint32_t t = 0; t < torus.patch_count(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t other = torus.adjacency().opposite[3 * t + k] / 3;
      EXPECT_EQ((frame_turn(torus, t, other) + frame_turn(torus, other, t)) % 8, 0u);
    }
  const CorrosionRule rule;
  for (unsigned k = 0; k < 8; ++k) {
    EXPECT_EQ(rule.turned(0x301u, k), 0x300u | 1u << k);
    EXPECT_EQ(rule.turned(rule.turned(0xA5B7u, k), (8 - k) % 8), 0xA5B7u);
  }
}

struct Case {
  const char* name;
  Mesh mesh;
  double cell_size;
  CorrosionForces forces;
  std::uint64_t lifetime;
};

TEST(CorrosionRule, AFrontGivesTheBitsOfAFullSweep) {
  const CorrosionForces slow, ring{.strong_defence = 1.0, .support = 0.1},
      calm{.luck = 0.0, .attack_age = 20, .reach_age = 1, .support = 0.05};
  const std::uint64_t never = ~std::uint64_t{0};
  const std::vector<Case> cases{{"torus", shapes::torus(3, 1, 20, 12), 0.06, slow, never},
                                {"torus, metal runs out", shapes::torus(3, 1, 20, 12), 0.06, slow, 30},
                                {"torus, metal runs out early", shapes::torus(3, 1, 20, 12), 0.06, slow, 3},
                                {"cube, strong cells hold", shapes::cube(1), 0.02, ring, never},
                                {"cube, both", shapes::cube(1), 0.02, ring, 40},
                                {"plane, no luck", shapes::random_plane(9, 40, 2), 1.0, calm, never},
                                {"few cells a triangle", shapes::torus(3, 1, 90, 40), 0.07, slow, never}};
  for (const Case& c : cases)
    for (const std::size_t threads : {1u, 4u}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      SCOPED_TRACE(c.name);
      const Surface s = make_surface(c.mesh, {.cell_size = c.cell_size});
      CorrosionRule rule(c.forces);
      rule.lifetime.fill(c.lifetime);
      const auto state = corrosion_start(s, rule, 0.35, 8, 3);
      SweepStepper<CorrosionRule> sweep(s, rule, state, 11);
      FrontStepper<CorrosionRule> front(s, rule, state, 11);
      const auto late = random_seeds(s, 60, 8);
      std::uint64_t visited = 0, swept = 0;
      for (std::size_t step = 0; step < 800 && !front.finished(); ++step) {
        if (step < late.size() && CorrosionRule::sound(front.state()[late[step].slot])) {
          const Word seed = CorrosionRule::corroded_word(step, front.state()[late[step].slot]);
          sweep.put(late[step].slot, seed);
          front.put(late[step].slot, seed);
        }
        const auto a = sweep.step(), b = front.step();
        ASSERT_EQ(a.changed, b.changed) << step;
        visited += b.visited;
        swept += a.visited;
        if (step % 10 == 0)
          each_owned(s, [&](std::uint32_t slot) { ASSERT_EQ(sweep.state()[slot], front.state()[slot]); });
      }
      EXPECT_LT(visited, swept / 2);
      each_owned(s, [&](std::uint32_t slot) { ASSERT_EQ(sweep.state()[slot], front.state()[slot]); });
    }
}

}  // namespace
