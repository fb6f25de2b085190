// Crack networks in numbers: junctions of three, spacing as asked, no trace of the triangles.
#include "verdigris/weathering/crack_network.hpp"

#include <tbb/global_control.h>

#include <cstdio>

#include "sheets.hpp"
#include "verdigris/automaton/spots.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

using namespace sheets;

// Fragments between cracks three cells wide.
std::size_t fragments(const Surface& s, const CrackNetwork& network) {
  Field<SpotCell> cells(s.slot_count(), SpotCell::nothing);
  each_owned(s, [&](std::uint32_t slot) {
    cells[slot] = network.distance[slot] > 1.5f ? SpotCell::in : SpotCell::out;
  });
  s.links().for_each([&](std::uint32_t source, auto ghosts) {
    for (const std::uint32_t ghost : ghosts) cells[ghost] = cells[source];
  });
  std::size_t count = 0;
  for (const std::uint64_t size : measure_spots(s, cells).sizes) count += size > 8;
  return count;
}

struct Counted {
  double spacing = 0.0, length = 0.0, threes = 0.0;
};

Counted counted(const Mesh& mesh, double side, double spacing, int seeds) {
  const Surface s = surface_of(mesh);
  Counted mean;
  for (int seed = 1; seed <= seeds; ++seed) {
    const CrackNetwork n = grow_cracks(s, {.spacing = spacing, .seed = static_cast<std::uint64_t>(seed)});
    mean.spacing += side / std::sqrt(static_cast<double>(fragments(s, n))) / seeds;
    mean.length += n.length * spacing / (side * side) / seeds;
    mean.threes += n.threes() / seeds;
  }
  return mean;
}

TEST(CrackNetwork, SpacingFollowsTheParameterAndThreeMeetMostly) {
  const double side = 400.0;
  for (const double spacing : {20.0, 30.0, 50.0}) {
    const Counted c = counted(sheet(side, 8, 5), side, spacing, 4);
    std::printf("spacing %g: %.3g, length x spacing / area %.3g, threes %.3f\n", spacing, c.spacing, c.length,
                c.threes);
    EXPECT_NEAR(c.spacing / spacing, 1.0, 0.12) << spacing;
    EXPECT_GT(c.threes, 0.87);  // ends two cells apart count as one junction of four
  }
}

TEST(CrackNetwork, DoesNotKnowTheTriangles) {
  const double side = 400.0, spacing = 30.0;
  const Counted plain = counted(sheet(side, 1, 0), side, spacing, 6);
  for (const auto& [n, seed] : {std::pair{8, 0u}, {8, 1u}, {16, 2u}, {40, 3u}}) {
    const Counted other = counted(sheet(side, n, seed), side, spacing, 6);
    std::printf("%d quads a side: spacing %.3g (2 triangles %.3g), length %.3g (%.3g), threes %.3f\n", n,
                other.spacing, plain.spacing, other.length, plain.length, other.threes);
    EXPECT_NEAR(other.spacing / plain.spacing, 1.0, 0.07) << n;
    EXPECT_NEAR(other.length / plain.length, 1.0, 0.07) << n;
    EXPECT_GT(other.threes, 0.9);
  }
}

TEST(CrackNetwork, FollowsEulerOnAClosedModel) {
  const Surface s = surface_of(shapes::torus(60.0, 25.0, 48, 24));
  const CrackNetwork n = grow_cracks(s, {.spacing = 25.0, .seed = 3});
  // With junctions of three only, and every fragment a disc: faces = vertices / 2 on a torus.
  const double corners = static_cast<double>(n.junctions[0] + 2 * n.junctions[1] + 3 * n.junctions[2]);
  EXPECT_NEAR(static_cast<double>(fragments(s, n)) / (0.5 * corners), 1.0, 0.1);
  EXPECT_EQ(n.ends_at_rim, 0u);
}

TEST(CrackNetwork, NothingCracksWithoutStrainAndMoreWhereThereIsMore) {
  const Surface s = surface_of(sheet(300.0, 6, 1));
  Field<float> strain(s.slot_count(), 0.0f);
  EXPECT_EQ(grow_cracks(s, {.spacing = 20.0}, strain).cracks, 0u);
  each_owned(s, [&](std::uint32_t slot) { strain[slot] = s.position(slot).x < 150.0 ? 1.0f : 0.4f; });
  const CrackNetwork n = grow_cracks(s, {.spacing = 20.0}, strain);
  std::size_t left = 0;
  for (const std::uint32_t slot : n.cells) left += s.position(slot).x < 150.0;
  EXPECT_GT(left, 3 * (n.cells.size() - left) / 2);
}

TEST(CrackNetwork, RepeatsItselfAndRefusesWhatCellsCannotShow) {
  const Surface s = surface_of(sheet(200.0, 6, 1));
  const CrackNetwork a = grow_cracks(s, {.spacing = 20.0, .seed = 9});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(a.cells, grow_cracks(s, {.spacing = 20.0, .seed = 9}).cells);
  EXPECT_NE(a.cells, grow_cracks(s, {.spacing = 20.0, .seed = 10}).cells);
  EXPECT_THROW(grow_cracks(s, {.spacing = 5.0}), InputError);
}

}  // namespace
}  // namespace verdigris
