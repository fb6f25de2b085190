#include <gtest/gtest.h>

#include "shapes.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"

using namespace verdigris;

namespace {

// A behaviour from outside the library: fire that burns out.
struct Fire {
  using State = std::uint8_t;  // 0 wood, 1 burning, 2 ash
  static constexpr const char* name = "fire";
  static constexpr const char* summary = "burns from cell to cell and leaves ash";
  double catches = 0.9, lit = 0.01;

  template <typename V>
  void parameters(V&& v) {
    v("catches", catches, 0.0, 1.0, "1", "chance a step to catch fire from a burning side");
    v("lit", lit, 0.0, 1.0, "1", "share of cells that burn at first");
  }
  State outside() const { return 2; }
  State initial(const CellRandom& random) const { return random.words(1)[0] < threshold(lit); }
  State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    if (*n.here != 0) return 2;
    for (int k = 0; k < 4; ++k)
      if (n.side(k) == 1 && random.words(2)[static_cast<std::size_t>(k)] < threshold(catches)) return 1;
    return 0;
  }
};

TEST(Catalogue, IsOpen) {
  Catalogue catalogue = builtin_catalogue();
  catalogue.add<Fire>();
  EXPECT_THROW(catalogue.add<Fire>(), std::invalid_argument);
  const BehaviourEntry& fire = catalogue.find("fire");
  ASSERT_EQ(fire.parameters.size(), 2u);
  EXPECT_EQ(fire.parameters[0].name, "catches");
  EXPECT_EQ(fire.parameters[0].default_value, ParameterValue(0.9));

  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.02});
  const auto simulation = fire.create({s, 1, {}, {}}, {{"catches", 1.0}});
  while (simulation->steps() < 1000 && simulation->step().changed != 0) {
  }
  EXPECT_FALSE(simulation->finished());  // a rule with chances has no end of its own
  EXPECT_EQ(fire.default_steps, 100u);
  const auto state = simulation->field("state");
  for (const Row& row : s.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) EXPECT_EQ(state[slot], 2);
  EXPECT_THROW(simulation->field("colour"), std::out_of_range);
}

TEST(Catalogue, RefusesWhatAParameterCannotBe) {
  const Catalogue catalogue = builtin_catalogue();
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.1});
  const BehaviourEntry& voronoi = catalogue.find("voronoi");
  const SimulationSetup setup{s, 1, {{s.owned(1).begin, 1.0}}, {}};
  EXPECT_NO_THROW(voronoi.create(setup, {{"corner", 0.3}}));
  EXPECT_THROW(voronoi.create(setup, {{"corner", 1.5}}), InputError);
  EXPECT_THROW(voronoi.create(setup, {{"corner", std::nan("")}}), InputError);
  EXPECT_THROW(voronoi.create(setup, {{"korner", 0.3}}), InputError);
  EXPECT_THROW(catalogue.find("voronoy"), InputError);
}

// Nothing happens before the fifth step: a step without a change ends no behaviour that has a clock.
struct Late {
  static constexpr const char *name = "late", *summary = "comes to life in the fifth step";
  using State = std::uint8_t;
  std::uint64_t now = 0;
  State outside() const { return 0; }
  State initial(const CellRandom&) const { return 0; }
  void begin_step(std::uint64_t step) { now = step; }
  State next(const Neighbourhood<State>& n, const CellRandom&) const { return now == 5 ? State{1} : *n.here; }
  template <typename V>
  void parameters(V&&) {}
};

TEST(Catalogue, AStepWithoutChangeEndsOnlyWhatRests) {
  Catalogue catalogue;
  catalogue.add<Late>();
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.1});
  const auto simulation = catalogue.find("late").create({s, 1}, {});
  std::uint64_t changed = 0;
  while (!simulation->finished() && simulation->steps() < 8) changed += simulation->step().changed;
  EXPECT_EQ(changed, s.owned_count());
}

}  // namespace
