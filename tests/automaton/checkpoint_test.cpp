// A run that is saved, dropped and taken up again makes the bits of one that was not.

#include "verdigris/automaton/checkpoint.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <functional>
#include <memory>

#include "growth.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/builtin.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"

using namespace growth;

namespace {

// What happened in one step, and all that can be seen after it.
struct Seen {
  std::uint64_t step, changed;
  bool finished;
  std::vector<Field<std::int32_t>> fields;
  std::vector<Field<float>> real_fields;
  friend bool operator==(const Seen&, const Seen&) = default;
};

// Evolving cells only: ghosts follow them.
Seen look(const Surface& s, const AnySimulation& simulation, std::uint64_t changed) {
  Seen seen{simulation.steps(), changed, simulation.finished(), {}, {}};
  const auto keep = [&](const auto& field, auto& cells) {
    for (const Row& row : s.rows())
      cells.insert(cells.end(), field.begin() + row.run_begin, field.begin() + row.run_end);
  };
  for (const FieldInfo& info : simulation.fields())
    if (info.real)
      keep(simulation.real_field(info.name), seen.real_fields.emplace_back());
    else
      keep(simulation.field(info.name), seen.fields.emplace_back());
  return seen;
}

using Make = std::function<std::unique_ptr<AnySimulation>()>;

// Runs to the end or `most` steps; `restart(k)` says where to drop the simulation and restore another one.
std::vector<Seen> run(const Surface& s, const Make& make, std::uint64_t most,
                      const std::function<bool(std::uint64_t)>& restart) {
  auto simulation = make();
  std::vector<Seen> all{look(s, *simulation, 0)};
  const auto maybe_restart = [&] {
    if (!restart(simulation->steps())) return;
    const SavedState saved = simulation->save();
    EXPECT_EQ(saved.step, simulation->steps());
    simulation = make();
    simulation->restore(saved);
    EXPECT_EQ(look(s, *simulation, all.back().changed), all.back()) << "after restart at " << saved.step;
  };
  maybe_restart();
  while (!simulation->finished() && simulation->steps() < most) {
    const std::uint64_t changed = simulation->step().changed;
    all.push_back(look(s, *simulation, changed));
    maybe_restart();
  }
  return all;
}

void expect_restarts(const Surface& s, const Make& make, std::uint64_t most = 400) {
  const auto straight = run(s, make, most, [](std::uint64_t) { return false; });
  ASSERT_GT(straight.size(), 5u);
  EXPECT_EQ(straight, run(s, make, most, [](std::uint64_t) { return true; })) << "restart after every step";
  for (const std::uint64_t k : {straight.size() / 7, straight.size() / 2, straight.size() - 1})
    EXPECT_EQ(straight, run(s, make, most, [&](std::uint64_t step) { return step == k; }))
        << "restart at " << k;
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(straight, run(s, make, most, [](std::uint64_t step) { return step % 5 == 3; })) << "one thread";
}

struct Shape {
  const char* name;
  Mesh mesh;
  double cell_size;
};

std::vector<Shape> shapes_to_try() {
  return {{"torus", shapes::torus(3, 1, 20, 12), 0.1},
          {"few cells a triangle", shapes::torus(3, 1, 60, 30), 0.11},
          {"triangles narrower than a cell", shapes::cylinder(1, 12, 60), 0.17},
          {"plane", shapes::random_plane(9, 40, 2), 1.6}};
}

TEST(Checkpoint, VoronoiGrowthGoesOn) {
  for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected})
    for (const Shape& shape : shapes_to_try())
      for (const bool uneven : {false, true}) {
        SCOPED_TRACE(std::string(shape.name) + (links == LinkKind::projected ? ", projected" : "") +
                     (uneven ? ", weights and barrier" : ""));
        const Surface s = make_surface(shape.mesh, {.cell_size = shape.cell_size, .links = links});
        SimulationSetup setup{s, 11, {}, {}};
        if (uneven) {
          setup.barrier.assign(s.slot_count(), 0);
          each_owned(s, [&](std::uint32_t slot) {
            setup.barrier[slot] = CellRandom(1, 2, slot).words(3)[0] < threshold(0.1);
          });
        }
        setup.seeds = random_seeds(s, 5, 5, setup.barrier);
        if (uneven)
          for (std::size_t k = 0; k < setup.seeds.size(); ++k)
            setup.seeds[k].weight = 1.0 / static_cast<double>(k + 1);
        expect_restarts(s, [&] { return std::make_unique<VoronoiGrowth>(setup, VoronoiParameters{}); });
      }
}

TEST(Checkpoint, WordsOf64Bits) {
  const Surface s = make_surface(shapes::square(1100), {.cell_size = 1.0});
  const SimulationSetup setup{s, 3, random_seeds(s, (std::size_t{1} << 20) + 1, 3), {}};
  VoronoiGrowth straight(setup, {}), begun(setup, {}), resumed(setup, {});
  straight.step();
  begun.step();
  ASSERT_FALSE(begun.finished());
  const SavedState saved = begun.save();
  EXPECT_EQ(saved.arrays[0].element_size, 8u);
  resumed.restore(saved);
  while (!straight.finished()) EXPECT_EQ(straight.step().changed, resumed.step().changed);
  EXPECT_TRUE(resumed.finished());
  EXPECT_EQ(straight.labels(), resumed.labels());
  EXPECT_EQ(straight.arrivals(), resumed.arrivals());
}

// New seeds, holding and idle cells, metal that runs out, masks.
TEST(Checkpoint, CorrosionGoesOn) {
  for (const Shape& shape : shapes_to_try()) {
    SCOPED_TRACE(shape.name);
    const Surface s = make_surface(shape.mesh, {.cell_size = shape.cell_size});
    SimulationSetup setup{s, 11, random_seeds(s, 3, 5)};
    for (const char* name : {"attack", "rate", "seeding"}) {
      setup.masks.push_back({name, Field<float>(s.slot_count())});
      each_owned(s, [&](std::uint32_t slot) {
        setup.masks.back().values[slot] =
            static_cast<float>(CellRandom(setup.masks.size(), 2, slot).words(3)[0] >> 8) / 16777216.0f;
      });
    }
    CorrosionParameters p;
    p.new_seeds = 1e-3;
    p.most_seeds = 12;
    p.forces = {.attack = 2.0, .attack_age = 6, .strong_defence = 1.0, .support = 0.2};
    p.thickness.metal = 40.0;
    p.thickness.k1 = 1.0;
    expect_restarts(
        s, [&] { return std::make_unique<CorrosionGrowth>(setup, p); }, 90);
  }
}

// 2^19 + 1 labels leave 12 bits for the arrival: 4094 steps, fewer than this strip is long.
TEST(LongCheckpoint, WordsThatWiden) {
  const Mesh strip{
      {{0, 0, 0}, {10000, 0, 0}, {10000, 120, 0}, {0, 120, 0}}, {{0, 1, 2}, {0, 2, 3}}, {}, {}, {}, {}};
  const Surface s = make_surface(strip, {.cell_size = 1.0});
  SimulationSetup setup{s, 3, {}, {}};
  each_owned(s, [&](std::uint32_t slot) {
    if (s.position(slot).x < 4400.0) setup.seeds.push_back({slot, 1.0});
  });
  VoronoiGrowth straight(setup, {});
  auto resumed = std::make_unique<VoronoiGrowth>(setup, VoronoiParameters{});
  while (!straight.finished()) {
    straight.step();
    resumed->step();
    const std::uint64_t step = straight.steps();
    if (step != 4000 && step != 4094 && step != 4095 && step != 5000) continue;
    const SavedState saved = resumed->save();
    EXPECT_EQ(saved.arrays[0].element_size, step <= 4094 ? 4u : 8u);
    resumed = std::make_unique<VoronoiGrowth>(setup, VoronoiParameters{});
    resumed->restore(saved);
  }
  EXPECT_GT(straight.steps(), 5000u);
  EXPECT_TRUE(resumed->finished());
  EXPECT_EQ(straight.arrivals(), resumed->arrivals());
  EXPECT_EQ(straight.labels(), resumed->labels());
}

// Swept, and random in every step.
struct Embers {
  using State = std::uint16_t;
  static constexpr const char* name = "embers";
  static constexpr const char* summary = "glow that wanders";
  double lit = 0.1;

  template <typename V>
  void parameters(V&& v) {
    v("lit", lit, 0.0, 1.0, "1", "share of cells that glow at first");
  }
  State outside() const { return 0; }
  State initial(const CellRandom& random) const { return random.words(1)[0] < threshold(lit); }
  State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    const State from = n.side(static_cast<int>(random.words(2)[0] & 3u));
    return from != 0 && random.words(3)[0] < threshold(0.97) ? static_cast<State>(from + 1) : State{0};
  }
  State merge(State mine, State theirs) const { return std::max(mine, theirs); }
};

// From a front, in two passes; cells may change more than once, and the front may die out.
struct Frost {
  using State = std::uint8_t;
  static constexpr const char* name = "frost";
  static constexpr const char* summary = "hardens in three stages";
  double corner = 0.3;

  template <typename V>
  void parameters(V&& v) {
    v("corner", corner, 0.0, 1.0, "1", "chance to spread");
  }
  State outside() const { return 0; }
  State initial(const CellRandom& random) const { return random.words(1)[0] < threshold(0.002); }
  bool settled(State s) const { return s == 3; }
  bool waits(const Neighbourhood<State>& n) const { return n.centre() != 3 && coldest(n) != 0; }
  State next(const Neighbourhood<State>& n, const CellRandom& random) const {
    if (n.centre() == 3 || coldest(n) == 0 || random.words(2)[0] >= threshold(corner)) return n.centre();
    return static_cast<State>(n.centre() + 1);
  }
  State merge(State mine, State theirs) const { return std::max(mine, theirs); }

 private:
  static State coldest(const Neighbourhood<State>& n) {
    State most = n.centre();
    for (int k = 0; k < 4; ++k) most = std::max(most, n.side(k));
    return most;
  }
};

TEST(Checkpoint, AnyBehaviourOfTheCatalogueGoesOn) {
  Catalogue catalogue = builtin_catalogue();
  catalogue.add<Embers>();
  catalogue.add<Frost>();
  for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected})
    for (const Shape& shape : shapes_to_try())
      for (const BehaviourEntry& entry : catalogue.entries()) {
        if (links == LinkKind::projected && !entry.on_projected) continue;
        SCOPED_TRACE(entry.name + " on " + shape.name + (links == LinkKind::projected ? ", projected" : ""));
        const Surface s = make_surface(shape.mesh, {.cell_size = shape.cell_size, .links = links});
        SimulationSetup setup{s, 4, {}, {}};
        if (entry.needs_seeds) setup.seeds = random_seeds(s, 7, 1);
        expect_restarts(
            s, [&] { return entry.create(setup, {}); }, 24);
      }
}

class SavedGrowth : public testing::Test {
 protected:
  void expect_refused(const SavedState& saved, const std::string& why) {
    VoronoiGrowth growth(setup, {});
    try {
      growth.restore(saved);
      ADD_FAILURE() << "taken, though " << why;
    } catch (const InputError& error) {
      EXPECT_NE(error.problem().find(why), std::string::npos) << error.what();
      EXPECT_FALSE(error.remedy().empty());
    }
  }
  SavedState after(std::uint64_t steps) {
    VoronoiGrowth growth(setup, {});
    while (growth.steps() < steps) growth.step();
    return growth.save();
  }

  Surface s = make_surface(shapes::cube(1), {.cell_size = 0.05});
  SimulationSetup setup{s, 3, random_seeds(s, 6, 3), {}};
};

TEST_F(SavedGrowth, HoldsAWordACell) {
  const SavedState saved = after(3);
  EXPECT_EQ(saved.find("cells", 4).bytes.size(), 4 * evolving_count(s));
  EXPECT_EQ(evolving_count(s), s.owned_count());
}

TEST_F(SavedGrowth, OfOtherShapeIsRefused) {
  SavedState saved = after(3);
  expect_refused({3, {}}, "no array");
  saved.arrays[0].bytes.resize(saved.arrays[0].bytes.size() - 4);
  expect_refused(saved, "cells, not");
  saved = after(3);
  saved.arrays[0].element_size = 2;
  expect_refused(saved, "bytes a number");
  saved = after(3);
  saved.arrays[1].name = "others";
  expect_refused(saved, "no array 'merged'");
}

TEST_F(SavedGrowth, OfImpossibleContentIsRefused) {
  SavedState saved = after(3);
  saved.step = 1;  // arrivals are later
  expect_refused(saved, "cannot have reached");
  saved = after(3);
  saved.arrays[0].bytes[0] = std::byte{7};  // label 7 of 6, or an arrival far ahead
  saved.arrays[0].bytes[1] = saved.arrays[0].bytes[2] = saved.arrays[0].bytes[3] = std::byte{0};
  expect_refused(saved, "cannot have reached");
  saved = after(3);
  saved.arrays[1] = save_numbers<std::uint32_t>("merged", std::vector<std::uint32_t>{0xFFFFFFF0u});
  expect_refused(saved, "names slot");
}

// The first difference, in words.
TEST(Identity, NamesWhatDiffers) {
  const Catalogue catalogue = builtin_catalogue();
  const BehaviourEntry& voronoi = catalogue.find("voronoi");
  const Surface s = make_surface(shapes::cube(1), {.cell_size = 0.05});
  const SimulationSetup setup{s, 3, random_seeds(s, 6, 3), {}};
  const RunIdentity saved = identity_of(voronoi, setup, {});
  EXPECT_EQ(saved, identity_of(voronoi, setup, {{"corner", voronoi.parameters[0].default_value}}));
  EXPECT_NO_THROW(check_identity("file", saved, saved));

  const auto expect_named = [&](const SimulationSetup& other, const ParameterValues& values,
                                const std::string& what) {
    try {
      check_identity("file", saved, identity_of(voronoi, other, values));
      ADD_FAILURE() << what << " may differ";
    } catch (const InputError& error) {
      EXPECT_EQ(error.where(), "file");
      EXPECT_NE(error.problem().find(": " + what), std::string::npos) << error.what();
    }
  };
  expect_named(setup, {{"corner", 0.3}}, "parameter corner was 0.2071067811865476, now 0.3");
  std::vector<Seed> heavier = setup.seeds, fewer = setup.seeds;
  heavier[2].weight = 2.0;
  fewer.pop_back();
  expect_named({s, 4, setup.seeds, {}}, {}, "seed of the random numbers was 3, now 4");
  expect_named({s, 3, heavier, {}}, {}, "seeds was 6");
  expect_named({s, 3, fewer, {}}, {}, "seeds was 6");
  expect_named({s, 3, setup.seeds, Field<std::uint8_t>(s.slot_count(), 0)}, {}, "barrier was none");
  const Surface larger = make_surface(shapes::cube(2), {.cell_size = 0.05});
  expect_named({larger, 3, setup.seeds, {}}, {}, "mesh hash");
  const Surface finer = make_surface(shapes::cube(1), {.cell_size = 0.04});
  expect_named({finer, 3, setup.seeds, {}}, {}, "cell size was 0.05, now 0.04");
  const Surface paired = make_surface(shapes::cube(1), {.cell_size = 0.05, .links = LinkKind::projected});
  expect_named({paired, 3, setup.seeds, {}}, {}, "links was unfolded, now projected");
  const Surface creased = make_surface(shapes::cube(1), {.cell_size = 0.05, .crease_angle = 30.0});
  expect_named({creased, 3, setup.seeds, {}}, {}, "layout of the cells");
}

}  // namespace
