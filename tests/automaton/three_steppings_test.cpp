// Full sweep, active rows, front: whatever a behaviour declares, the same bits.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "growth.hpp"
#include "verdigris/automaton/active.hpp"
#include "verdigris/automaton/sweep.hpp"
#include "verdigris/behaviours/life.hpp"

using namespace growth;

namespace {

// Catches from a burning neighbour with a chance, burns for some steps, and is ash: cells wait and pass on.
struct Fire {
  using State = std::uint8_t;  // 0 wood, 1..5 burning, 6 ash
  State outside() const { return 0; }
  bool settled(State s) const { return s == 6; }
  static bool burning(State s) { return s > 0 && s < 6; }
  static bool near(const Neighbourhood<State>& n) {
    for (int k = 0; k < 4; ++k)
      if (burning(n.side(k)) || burning(n.corner(k))) return true;
    return false;
  }
  bool waits(const Neighbourhood<State>& n) const { return *n.here == 0 ? near(n) : *n.here < 6; }
  State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    if (*n.here != 0) return *n.here == 6 ? State{6} : static_cast<State>(*n.here + 1);
    return near(n) && random.words(77)[0] < threshold(0.4) ? State{1} : State{0};
  }
};

struct Shape {
  const char* name;
  Mesh mesh;
  double cell_size;
};

std::vector<Shape> all_shapes() {
  return {{"torus", shapes::torus(3, 1, 20, 12), 0.06},
          {"cube", shapes::cube(1), 0.013},
          {"few cells a triangle", shapes::torus(3, 1, 90, 40), 0.07},
          {"narrow triangles", shapes::cylinder(1, 12, 60), 0.17},
          {"plane", shapes::random_plane(9, 40, 2), 1.0}};
}

template <typename State>
void expect_equal_cells(const Surface& s, const Field<State>& a, const Field<State>& b) {
  for (const Row& row : s.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) ASSERT_EQ(a[slot], b[slot]) << slot;
}

template <Behaviour B>
void expect_one_result(const Surface& s, const B& rule, const Field<typename B::State>& state, int steps) {
  SweepStepper<B> sweep(s, rule, state, 5);
  ActiveStepper<B> active(s, rule, state, 5);
  std::uint64_t visited = 0, swept = 0;
  const auto run = [&](auto step_front) {
    for (int step = 0; step < steps; ++step) {
      const StepReport a = sweep.step(), b = active.step();
      ASSERT_EQ(a.changed, b.changed) << "step " << step;
      ASSERT_LE(b.visited, a.visited);
      swept += a.visited;
      visited += b.visited;
      step_front(a);
      if (step % 7 == 0) expect_equal_cells(s, sweep.state(), active.state());
    }
    expect_equal_cells(s, sweep.state(), active.state());
  };
  if constexpr (FrontBehaviour<B>) {
    FrontStepper<B> front(s, rule, state, 5);
    run([&](const StepReport& swept_step) {
      const StepReport c = front.step();
      ASSERT_EQ(swept_step.changed, c.changed);
      ASSERT_LE(c.visited, swept_step.visited);
    });
    expect_equal_cells(s, sweep.state(), front.state());
  } else {
    run([](const StepReport&) {});
  }
  EXPECT_LT(visited, swept);
}

template <typename Check>
void on_all_shapes(Check&& check, bool projected) {
  for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected}) {
    if (links == LinkKind::projected && !projected) continue;
    for (const Shape& shape : all_shapes())
      for (const std::size_t threads : {std::size_t{1}, std::size_t{3}}) {
        SCOPED_TRACE(std::string(shape.name) + (links == LinkKind::projected ? ", projected, " : ", ") +
                     std::to_string(threads) + " threads");
        const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        check(make_surface(shape.mesh, {.cell_size = shape.cell_size, .links = links}));
      }
  }
}

TEST(ThreeSteppings, VoronoiGrowth) {
  on_all_shapes(
      [](const Surface& s) {
        VoronoiRule<std::uint32_t> rule;
        rule.label_bits = 3;
        Field<std::uint32_t> state(s.slot_count(), rule.empty);
        std::uint64_t label = 0;
        for (const Seed& seed : random_seeds(s, 8, 5)) state[seed.slot] = rule.word(0, label++);
        expect_one_result(s, rule, state, 60);
        rule.speed = {1.0, 0.5, 0.3, 0.77, 1.0, 1.0, 0.9, 0.25};
        expect_one_result(s, rule, state, 60);
      },
      true);
}

TEST(ThreeSteppings, Fire) {
  on_all_shapes(
      [](const Surface& s) {
        Field<std::uint8_t> state(s.slot_count(), 0);
        for (const Seed& seed : random_seeds(s, 5, 5)) state[seed.slot] = 1;
        expect_one_result(s, Fire{}, state, 80);
      },
      false);
}

// A patch of soup on an empty world: most rows rest.
TEST(ThreeSteppings, Life) {
  for (const char* text : {"B3/S23", "B36/S23", "B13/S024V"})
    on_all_shapes(
        [&](const Surface& s) {
          Field<std::uint8_t> state(s.slot_count(), 0);
          const glm::dvec3 middle = s.position(random_seeds(s, 1, 2)[0].slot);
          each_owned(s, [&](std::uint32_t slot) {
            const glm::dvec3 d = s.position(slot) - middle;
            state[slot] = d.x * d.x + d.y * d.y + d.z * d.z < 64.0 * s.cell_size() * s.cell_size() &&
                          CellRandom(7, 0, slot).words(1)[0] < threshold(0.5);
          });
          expect_one_result(s, LifeBehaviour{parse_life_rule(text)}, state, 50);
        },
        false);
}

// Rows of any length, whole vectors or not: the lanes agree with the rule cell by cell.
TEST(ThreeSteppings, LanesAreTheRule) {
  for (const char* text : {"B3/S23", "B2/S", "B0/S8", "B378/S235678", "B13/S024V"}) {
    const LifeBehaviour life{parse_life_rule(text)};
    for (const double size : {0.3, 0.09, 0.04, 0.02, 0.011, 0.0042}) {
      const Surface s = make_surface(shapes::cube(1), {.cell_size = size});
      Field<std::uint8_t> state(s.slot_count(), 0), next(s.slot_count(), 9);
      for (std::uint32_t slot = 0; slot < s.slot_count(); ++slot)
        state[slot] = CellRandom(7, 0, slot).words(1)[0] < threshold(0.5);
      for (std::uint32_t r = 0; r < s.rows().size(); ++r) {
        if (s.rows()[r].run_begin == s.rows()[r].run_end) continue;
        std::uint64_t changed = 0;
        const std::uint64_t said = evaluate_row(s, r, life, state.data(), next.data(), 1, 1);
        const Row* row = s.rows().data() + r;
        for (std::uint32_t slot = row->run_begin; slot < row->run_end; ++slot) {
          const std::uint32_t column = slot - row->base;
          const Neighbourhood<std::uint8_t> n{
              state.data() + static_cast<std::uint32_t>(row[-1].base + column), state.data() + slot,
              state.data() + static_cast<std::uint32_t>(row[1].base + column)};
          ASSERT_EQ(next[slot], life.next(n, CellRandom(1, 1, slot))) << text << " " << size;
          changed += next[slot] != state[slot];
        }
        ASSERT_EQ(said, changed);
        // Nothing beyond the row is touched: there are guards on both sides.
        ASSERT_EQ(next[row->run_begin - 1], 9);
        ASSERT_EQ(next[row->run_end], 9);
      }
    }
  }
}

}  // namespace
