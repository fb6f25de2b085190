#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <glm/geometric.hpp>

#include "shapes.hpp"
#include "verdigris/automaton/sweep.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/behaviours/larger_than_life.hpp"
#include "verdigris/behaviours/life.hpp"
#include "verdigris/surface/flat_torus.hpp"

using namespace verdigris;

namespace {

// As the rule is defined, cell by cell.
std::vector<std::uint8_t> reference_step(const std::vector<std::uint8_t>& cells, int width, int height,
                                         const RangeRule& rule) {
  std::vector<std::uint8_t> next(cells.size());
  const int r = static_cast<int>(rule.range);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::size_t live = 0;
      for (int dy = -r; dy <= r; ++dy)
        for (int dx = -r; dx <= r; ++dx) {
          const bool counted = rule.shape == RangeShape::moore         ? true
                               : rule.shape == RangeShape::von_neumann ? std::abs(dx) + std::abs(dy) <= r
                                                                       : dx * dx + dy * dy <= r * r + r;
          if (counted && (rule.middle || dx != 0 || dy != 0))
            live += cells[static_cast<std::size_t>((y + dy + height) % height * width +
                                                   (x + dx + width) % width)];
        }
      const auto at = static_cast<std::size_t>(y * width + x);
      next[at] = (cells[at] != 0 ? rule.survival : rule.birth)[live];
    }
  return next;
}

const char* const rules[] = {"R1,C0,M0,S2..3,B3..3,NM",          "R2,C2,M1,S6-9,B7,8,NM",
                             "R3,C0,M0,S8-17,B9-13,15,NN",       "R5,C0,M1,S34..58,B34..45,NM",
                             "R10,C0,M1,S123..212,B123..170,NM", "R10,C2,M0,S70-150,B75-110,NC"};

TEST(RangeRule, IsReadAndWritten) {
  const RangeRule bugs = parse_range_rule("R5,C0,M1,S34..58,B34..45,NM");
  EXPECT_EQ(bugs.range, 5u);
  EXPECT_EQ(bugs.cells_counted(), 121u);
  EXPECT_EQ(bugs.survival[34] + bugs.survival[58] + bugs.birth[45], 3);
  EXPECT_EQ(bugs.survival[33] + bugs.survival[59] + bugs.birth[46], 0);
  EXPECT_EQ(parse_range_rule("r2,s3,b3,nn").cells_counted(), 12u);
  EXPECT_EQ(parse_range_rule("R3,C2,S,B1,NC").cells_counted(), 36u);
  for (const char* text : rules) {
    const RangeRule rule = parse_range_rule(text);
    EXPECT_EQ(parse_range_rule(range_rule_text(rule)), rule) << text;
  }
  for (const char* text :
       {"", "R5", "R0,S1,B1", "R11,S1,B1", "R2,C3,S1,B1", "R2,S1,B99", "R2,S5-3,B1", "R2,S1,B1,NX",
        "R2,M2,S1,B1", "R2,S1,,B1", "R2,S1,B1,Q", "R,S1,B1", "R2,Sx,B1", "R2,S1..,B1", "7,R2,S1,B1"})
    EXPECT_THROW(parse_range_rule(text), InputError) << text;
}

TEST(LargerThanLife, AgreesWithAPlainTorus) {
  for (const char* text : rules)
    for (const std::uint32_t patch : {8u, 30u, 64u}) {
      const std::uint32_t w = (64 / patch + 1) * patch, h = w;
      const RangeRule rule = parse_range_rule(text);
      const Surface s = make_flat_torus(w, h, patch);
      const Halo halo(s, rule.range);
      std::vector<std::uint32_t> slot_at(std::size_t{w} * h);
      std::vector<std::uint8_t> cells(slot_at.size());
      Field<std::uint8_t> alive(s.slot_count(), 0);
      for (const Row& row : s.rows())
        for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
          const TorusCell c = torus_cell(s, slot, w, h);
          slot_at[c.y * w + c.x] = slot;
        }
      for (std::size_t k = 0; k < cells.size(); ++k)
        alive[slot_at[k]] = cells[k] =
            CellRandom(3, 0, static_cast<std::uint32_t>(k)).words(1)[0] < threshold(0.45);
      LargerThanLife life(halo, rule, alive);
      for (int step = 0; step < 8; ++step) {
        const auto next = reference_step(cells, static_cast<int>(w), static_cast<int>(h), rule);
        std::uint64_t changed = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) changed += next[k] != cells[k];
        cells = next;
        ASSERT_EQ(life.step(), changed) << text << ", patch " << patch << ", step " << step;
        for (std::size_t k = 0; k < cells.size(); ++k)
          ASSERT_EQ(life.alive()[slot_at[k]], cells[k]) << text << ", patch " << patch << ", step " << step;
      }
    }
}

// The halo of range 1 is the ghosts: the rule is the byte behaviour's, on any surface.
TEST(LargerThanLife, OfRangeOneIsLife) {
  for (const Mesh& mesh : {shapes::torus(3, 1, 30, 20), shapes::square(1), shapes::random_plane(9, 40, 2)}) {
    const Surface s = make_surface(mesh, {.cell_size = cell_size_for(mesh, 20000)});
    const Halo halo(s, 1);
    Field<std::uint8_t> state(s.slot_count(), 0);
    for (const Row& row : s.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        state[slot] = CellRandom(7, 0, slot).words(1)[0] < threshold(0.5);
    SweepStepper<LifeBehaviour> bytes(s, {parse_life_rule("B3/S23")}, state, 1);
    LargerThanLife life(halo, parse_range_rule("R1,C0,M0,S2..3,B3..3,NM"), state);
    for (int step = 0; step < 20; ++step) ASSERT_EQ(life.step(), bytes.step().changed) << step;
    for (const Row& row : s.rows())
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
        ASSERT_EQ(life.alive()[slot], bytes.state()[slot]);
  }
}

TEST(Halo, CoversWhatIsInReachOnAClosedSurface) {
  const Surface s = make_surface(shapes::torus(3, 1, 30, 20), {.cell_size = 0.03});
  for (const unsigned reach : {1u, 4u, 10u}) {
    const Halo halo(s, reach);
    for (std::uint32_t p = 0; p < s.patch_count(); ++p)
      for (const HaloCell& cell : halo.cells(p)) {
        ASSERT_TRUE(s.is_owned(cell.source));
        // As far away through space as on the raster, or nearer: the torus is bent.
        const auto row =
            static_cast<std::int32_t>(cell.offset / halo.patch(p).width) - static_cast<std::int32_t>(reach);
        const auto column = static_cast<std::int32_t>(cell.offset % halo.patch(p).width) + halo.patch(p).left;
        const glm::dvec3 there = s.frame(p).to_model(s.centre(row, column)), found = s.position(cell.source);
        ASSERT_LT(glm::length(there - found), s.cell_size() * (1.5 + 0.5 * reach));
      }
  }
}

TEST(Halo, RefusesTrianglesFarSmallerThanItsReach) {
  const Surface s = make_surface(shapes::torus(3, 1, 90, 60), {.cell_size = 0.12});
  EXPECT_THROW(Halo(s, 10), InputError);
  EXPECT_NO_THROW(Halo(s, 1));
}

std::vector<std::int32_t> alive_after(const Surface& s, const std::string& rule, std::size_t threads,
                                      int steps, int restart_at) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const Catalogue catalogue = builtin_catalogue();
  const SimulationSetup setup{s, 5};
  auto life = catalogue.find("life").create(setup, {{"rule", rule}});
  for (int step = 0; step < steps; ++step) {
    if (step == restart_at) {
      const SavedState saved = life->save();
      life = catalogue.find("life").create(setup, {{"rule", rule}});
      life->restore(saved);
    }
    life->step();
  }
  EXPECT_EQ(life->steps(), static_cast<std::uint64_t>(steps));
  return life->field("alive");
}

TEST(LifeSimulation, SameBitsForThreadsAndAfterRestart) {
  const Surface s = make_surface(shapes::torus(3, 1, 30, 20), {.cell_size = 0.03});
  for (const char* rule : {"life", "R5,C0,M1,S34..58,B34..45,NM"}) {
    const auto once = alive_after(s, rule, 1, 20, -1);
    EXPECT_GT(std::count(once.begin(), once.end(), 1), 100) << rule;
    EXPECT_EQ(once, alive_after(s, rule, 3, 20, -1)) << rule;
    EXPECT_EQ(once, alive_after(s, rule, 2, 20, 13)) << rule;
  }
}

TEST(LifeSimulation, RefusesWhatItCannotDo) {
  const Surface projected = make_surface(shapes::cube(1), {.cell_size = 0.05, .links = LinkKind::projected});
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.05});
  const BehaviourEntry life = builtin_catalogue().find("life");
  EXPECT_THROW(life.create({projected, 1}, {}), InputError);
  EXPECT_THROW(life.create({s, 1, {}, Field<std::uint8_t>(s.slot_count(), 0)}, {}), InputError);
  EXPECT_THROW(life.create({s, 1}, {{"rule", std::string("nonsense")}}), InputError);
  EXPECT_THROW(life.create({s, 1}, {{"rule", 3.0}}), InputError);
  auto packed = life.create({s, 1}, {});
  SavedState foreign = packed->save();
  foreign.arrays[0].bytes.assign(foreign.arrays[0].bytes.size(), std::byte{0xFF});
  EXPECT_THROW(packed->restore(foreign), InputError);
}

}  // namespace
