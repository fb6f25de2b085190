#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <set>

#include "shapes.hpp"
#include "verdigris/automaton/sweep.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/packed_life.hpp"
#include "verdigris/surface/flat_torus.hpp"

using namespace verdigris;

namespace {

TEST(LifeRule, ReadsEveryNotation) {
  const LifeRule life;
  for (const char* text : {"B3/S23", "b3/s23", "S23/B3", "23/3", "Life", "life"})
    EXPECT_EQ(parse_life_rule(text), life) << text;
  EXPECT_EQ(parse_life_rule("235678/378"), parse_life_rule("Coagulations"));
  EXPECT_EQ(parse_life_rule("1358/357"), parse_life_rule("amoeba"));
  EXPECT_EQ(parse_life_rule("B2/S").survival, 0);
  EXPECT_EQ(parse_life_rule("B13/S024V").neighbourhood, LifeNeighbourhood::von_neumann);
  for (const auto& [name, text] : life_rule_names()) EXPECT_EQ(life_rule_text(parse_life_rule(name)), text);
  for (const char* text :
       {"", "B3", "B3S23", "B9/S23", "B3/B3", "B3/23", "conway", "B5/S2V", "23/3/3", "B3/S2 3"})
    EXPECT_THROW(parse_life_rule(text), InputError) << text;
}

// A plain torus, as anyone would write it.
std::vector<std::uint8_t> reference_step(const std::vector<std::uint8_t>& cells, int width, int height,
                                         const LifeRule& rule) {
  std::vector<std::uint8_t> next(cells.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      int live = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if ((dx != 0 || dy != 0) && (rule.neighbourhood == LifeNeighbourhood::moore || dx == 0 || dy == 0))
            live += cells[static_cast<std::size_t>((y + dy + height) % height * width +
                                                   (x + dx + width) % width)];
      const auto at = static_cast<std::size_t>(y * width + x);
      next[at] = ((cells[at] != 0 ? rule.survival : rule.birth) >> live & 1) != 0;
    }
  return next;
}

struct Torus {
  std::uint32_t width, height;
  Surface surface;
  PackedSurface packed;
  std::vector<std::uint32_t> bit;  // [y * width + x]

  Torus(std::uint32_t w, std::uint32_t h, std::uint32_t patch)
      : width(w), height(h), surface(make_flat_torus(w, h, patch)), packed(surface), bit(w * h, 0) {
    for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
      for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot) {
        const TorusCell c = torus_cell(surface, slot, w, h);
        bit[c.y * w + c.x] = packed.bit_of(surface, slot);
      }
  }
  void put(PackedLife& life, const std::vector<std::uint8_t>& cells) const {
    for (std::size_t k = 0; k < cells.size(); ++k) life.set(bit[k], cells[k] != 0);
  }
  std::vector<std::uint8_t> get(const PackedLife& life) const {
    std::vector<std::uint8_t> cells;
    for (const std::uint32_t b : bit) cells.push_back(life.alive(b));
    return cells;
  }
};

TEST(FlatTorus, IsOneLattice) {
  for (const std::uint32_t patch : {4u, 10u, 64u, 130u}) {
    const std::uint32_t w = patch * 3, h = patch * 2;
    const Surface s = make_flat_torus(w, h, patch);
    EXPECT_EQ(s.owned_count(), std::size_t{w} * h);
    EXPECT_EQ(s.open_ghost_count(), 0u);
    EXPECT_EQ(s.lost_ghost_count(), 0u);
    std::set<std::pair<std::uint32_t, std::uint32_t>> cells;
    for (std::uint32_t r = 0; r < s.rows().size(); ++r)
      for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; ++slot) {
        const TorusCell c = torus_cell(s, slot, w, h);
        EXPECT_TRUE(cells.emplace(c.x, c.y).second);
      }
  }
  EXPECT_THROW(make_flat_torus(10, 10, 5), InputError);
  EXPECT_THROW(make_flat_torus(12, 10, 4), InputError);
}

// What is put between two steps reaches the ghosts too.
TEST(PackedLife, GoesOnFromWhatIsPutBetweenSteps) {
  const Torus t(128, 128, 64);
  const LifeRule rule = parse_life_rule("B3/S23");
  PackedLife life(t.packed, rule);
  life.fill(0.5, 1);
  const auto go_on = [&](const char* after) {
    auto cells = t.get(life);
    for (int step = 0; step < 5; ++step) {
      cells = reference_step(cells, 128, 128, rule);
      life.step();
      ASSERT_EQ(t.get(life), cells) << after << ", step " << step;
    }
  };
  go_on("fill");
  const std::vector<std::uint64_t> kept = life.state();
  life.fill(0.3, 2);
  go_on("another fill");
  std::vector<std::uint8_t> soup(t.bit.size());
  for (std::size_t k = 0; k < soup.size(); ++k)
    soup[k] = CellRandom(5, 0, static_cast<std::uint32_t>(k)).words(1)[0] < threshold(0.4);
  t.put(life, soup);
  go_on("set");
  life.restore(kept, 5);
  EXPECT_EQ(life.steps(), 5u);
  go_on("restore");
}

TEST(PackedLife, AgreesWithAPlainTorus) {
  for (const char* rule :
       {"B3/S23", "B378/S235678", "B357/S1358", "B2/S", "B3678/S34678", "B08/S08", "B13/S024V"})
    for (const std::uint32_t patch : {10u, 64u, 150u}) {
      const Torus t(2 * patch, 2 * patch, patch);
      PackedLife life(t.packed, parse_life_rule(rule));
      std::vector<std::uint8_t> cells(t.width * t.height);
      for (std::size_t k = 0; k < cells.size(); ++k)
        cells[k] = CellRandom(3, 0, static_cast<std::uint32_t>(k)).words(1)[0] < threshold(0.5);
      t.put(life, cells);
      for (int step = 0; step < 40; ++step) {
        const auto next = reference_step(cells, static_cast<int>(t.width), static_cast<int>(t.height),
                                         parse_life_rule(rule));
        std::uint64_t changed = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) changed += next[k] != cells[k];
        cells = next;
        ASSERT_EQ(life.step(), changed) << rule << ", " << patch << ", step " << step;
        ASSERT_EQ(t.get(life), cells) << rule << ", " << patch << ", step " << step;
      }
    }
}

TEST(PackedLife, GlidersCrossTriangleEdges) {
  // Once round the torus and back to where it began: 4 generations move a glider by one cell on both axes.
  const Torus t(48, 48, 16);
  PackedLife life(t.packed, LifeRule{});
  std::vector<std::uint8_t> cells(48 * 48, 0);
  for (const auto& [x, y] : {std::pair{1, 0}, {2, 1}, {0, 2}, {1, 2}, {2, 2}})
    cells[static_cast<std::size_t>(y * 48 + x)] = 1;
  t.put(life, cells);
  for (int step = 0; step < 4 * 48; ++step) {
    life.step();
    ASSERT_EQ(life.population(), 5u) << step;
  }
  EXPECT_EQ(t.get(life), cells);
}

TEST(PackedLife, AgreesWithTheByteBehaviourOnAnySurface) {
  const struct {
    Mesh mesh;
    double cell_size;
  } all[] = {{shapes::torus(3, 1, 30, 20), 0.03},
             {shapes::cube(1), 0.004},
             {shapes::square(1), 0.02},
             {shapes::random_plane(9, 40, 2), 1.0},
             {shapes::torus(3, 1, 90, 40), 0.07},
             {shapes::torus(3, 1, 400, 3), 0.02},
             {shapes::torus(3, 1, 400, 200), 0.07},  // most triangles hold no cell
             {shapes::cube(1), 10.0}};               // none does
  for (const auto& [mesh, h] : all)
    for (const char* text : {"B3/S23", "Coagulations", "B13/S024V", "B08/S0128"}) {
      const LifeRule rule = parse_life_rule(text);
      const Surface s = make_surface(mesh, {.cell_size = h});
      const PackedSurface packed(s);
      PackedLife life(packed, rule);
      Field<std::uint8_t> state(s.slot_count(), 0);
      for (std::uint32_t r = 0; r < s.rows().size(); ++r)
        for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; ++slot) {
          state[slot] = CellRandom(7, 0, slot).words(1)[0] < threshold(0.5);
          life.set(packed.bit_of(s, slot), state[slot] != 0);
        }
      SweepStepper<LifeBehaviour> bytes(s, {rule}, state, 1);
      for (int step = 0; step < 20; ++step)
        ASSERT_EQ(life.step(), bytes.step().changed) << text << ", step " << step;
      for (std::uint32_t r = 0; r < s.rows().size(); ++r)
        for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; ++slot)
          ASSERT_EQ(life.alive(packed.bit_of(s, slot)), bytes.state()[slot] != 0);
    }
}

TEST(PackedLife, AnyNumberOfThreadsGivesTheSameBits) {
  const Surface s = make_surface(shapes::torus(3, 1, 60, 40), {.cell_size = 0.01});
  const PackedSurface packed(s);
  const auto run = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    PackedLife life(packed, LifeRule{});
    life.fill(0.5, 9);
    for (int step = 0; step < 30; ++step) life.step();
    return life.state();
  };
  const auto one = run(1);
  EXPECT_EQ(one, run(2));
  EXPECT_EQ(one, run(5));
}

TEST(PackedLife, FillsToTheDensityAskedFor) {
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.004});
  const PackedSurface packed(s);
  PackedLife life(packed, LifeRule{});
  life.fill(0.3, 2);
  EXPECT_NEAR(static_cast<double>(life.population()) / static_cast<double>(packed.owned_count()), 0.3, 0.005);
  life.fill(0.0, 2);
  EXPECT_EQ(life.population(), 0u);
  life.fill(1.0, 2);
  EXPECT_EQ(life.population(), packed.owned_count());
}

}  // namespace
