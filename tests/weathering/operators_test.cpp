// Operators: what each keeps, takes and adds.
#include "verdigris/weathering/operators.hpp"

#include <tbb/global_control.h>

#include <glm/geometric.hpp>

#include "sheets.hpp"
#include "verdigris/automaton/spots.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/io/read_mesh.hpp"

namespace verdigris {
namespace {

using namespace sheets;

CoatedMetal painted(const Surface& s, double thickness = 80.0, double variation = 0.0) {
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  apply(metal, {s}, "coat", {{"thickness", thickness}, {"variation", variation}});
  return metal;
}

TEST(Coat, IsAsThickAsAsked) {
  const Surface s = surface_of(sheet(100.0, 5, 1));
  CoatedMetal metal = painted(s);
  ASSERT_EQ(metal.coats.size(), 3u);
  each_owned(s, [&](std::uint32_t slot) { ASSERT_EQ(metal.coats[2].thickness[slot], 80.0f); });
  for (const char* along : {"", "x"}) {
    metal = make_coated_metal(s, find_material("bare-steel"));
    const auto report =
        apply(metal, {s}, "coat", {{"thickness", 50.0}, {"variation", 0.4}, {"along", std::string(along)}});
    const Field<float>& t = metal.coats[2].thickness;
    const auto cells = static_cast<double>(s.owned_count());
    EXPECT_NEAR(total(s, t) / cells, 50.0, 1e-3);
    EXPECT_NEAR(report.added / cells, 50.0, 1e-3);
    float low = 1e9f, high = 0.0f;
    each_owned(s, [&](std::uint32_t slot) { low = std::min(low, t[slot]), high = std::max(high, t[slot]); });
    EXPECT_GE(low, 0.0f);
    EXPECT_GT(high - low, 15.0f);
  }
  EXPECT_THROW(apply(metal, {s}, "coat", {{"colour", std::string("blue")}}), InputError);
  EXPECT_THROW(apply(metal, {s}, "coat"), InputError);  // a second coat of one name
}

TEST(Erode, TakesTheUppermostFirstAndNeverBelowZero) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal metal = painted(s, 30.0);
  apply(metal, {s}, "coat", {{"layer", std::string("varnish")}, {"thickness", 10.0}, {"variation", 0.0}});
  auto report = apply(metal, {s}, "erode", {{"depth", 15.0}, {"unevenness", 0.0}});
  each_owned(s, [&](std::uint32_t slot) {
    ASSERT_EQ(metal.coats[3].thickness[slot], 0.0f);
    ASSERT_EQ(metal.coats[2].thickness[slot], 25.0f);
  });
  EXPECT_NEAR(report.removed, 15.0 * static_cast<double>(s.owned_count()), 1e-6);
  report = apply(metal, {s}, "erode", {{"depth", 40.0}, {"unevenness", 0.0}, {"into_metal", 0.2}});
  each_owned(s, [&](std::uint32_t slot) {
    ASSERT_EQ(metal.coats[2].thickness[slot], 0.0f);
    ASSERT_NEAR(metal.loss[slot], 0.2 * 15.0, 1e-5);
  });
  apply(metal, {s}, "erode", {{"depth", 1e6}, {"into_metal", 1.0}});
  each_owned(s, [&](std::uint32_t slot) { ASSERT_TRUE(metal.loss[slot] <= 3000.0f); });
}

TEST(Polish, TakesConvexPartsFirst) {
  const Surface s = surface_of(read_mesh(VERDIGRIS_MESHES "/cube.obj"), 0.02);
  CoatedMetal metal = painted(s, 20.0);
  apply(metal, {s}, "polish", {{"depth", 20.0}});
  double edges = 0.0, middles = 0.0;
  int at_edges = 0, in_middles = 0;
  each_owned(s, [&](std::uint32_t slot) {
    const glm::dvec3 p = s.position(slot) - mesh_bounds(s.mesh()).lower;
    // Distance to the nearest edge of the cube: the second least distance to a face plane.
    double d[3];
    for (int k = 0; k < 3; ++k) d[k] = std::min(p[k], 1.0 - p[k]);
    std::sort(d, d + 3);
    if (d[1] < 0.02) edges += static_cast<double>(metal.coats[2].thickness[slot]), ++at_edges;
    if (d[1] > 0.2) middles += static_cast<double>(metal.coats[2].thickness[slot]), ++in_middles;
  });
  EXPECT_GT(at_edges, 100);
  EXPECT_GT(in_middles, 100);
  EXPECT_LT(edges / at_edges, 10.0);
  EXPECT_GT(middles / in_middles, 19.9);
}

TEST(Scratch, CutsAsWideAsAskedAndCountsWhatItDraws) {
  const Surface s = surface_of(sheet(300.0, 6, 1));
  const auto area = [&](double width) {
    CoatedMetal metal = painted(s);
    const auto report =
        apply(metal, {s}, "scratch", {{"count", 2.0}, {"length", 0.6}, {"depth", 1000.0}, {"width", width}});
    EXPECT_NEAR(report.removed, 80.0 * static_cast<double>(report.cells), 1e-3);
    return static_cast<double>(report.cells);
  };
  const double ten = area(10.0), twenty = area(20.0);
  EXPECT_NEAR(ten / area(5.0), 2.0, 0.35);
  EXPECT_NEAR(twenty / ten, 2.0, 0.35);
  // Wide cuts reach over the edges of triangles.
  EXPECT_NEAR((area(40.0) - twenty) / (twenty - ten), 2.0, 0.25);
  // `where` is the chance that one is drawn.
  CoatedMetal metal = painted(s);
  Field<float> half(s.slot_count(), 0.5f), none(s.slot_count(), 0.0f);
  OperatorSetup setup{s};
  const auto drawn = [&](const Field<float>& where) {
    setup.masks = {{"where", where}};
    return apply(metal, setup, "scratch", {{"count", 200.0}, {"length", 0.01}}).numbers.at(0).second;
  };
  EXPECT_NEAR(drawn(half), 100.0, 30.0);
  EXPECT_EQ(drawn(none), 0.0);
}

TEST(Crack, TakesOffWhatTheCoatLoses) {
  const Surface s = surface_of(sheet(200.0, 6, 1));
  CoatedMetal metal = painted(s, 80.0, 0.3);
  const double before = total(s, metal.coats[2].thickness);
  const auto report = apply(metal, {s}, "crack", {{"spacing", 0.15}, {"width", 3.0}, {"depth", 60.0}});
  const double lost = before - total(s, metal.coats[2].thickness);
  EXPECT_GT(lost, 0.0);
  EXPECT_NEAR(report.removed, lost, 1e-6 * before);
  std::uint64_t damaged = 0;
  each_owned(s, [&](std::uint32_t slot) { damaged += metal.damage[slot] == 1.0f; });
  EXPECT_EQ(report.cells, damaged);
}

TEST(Peel, FlakesAreWholeAndVolumeIsThatOfTheLostCoat) {
  const Surface s = surface_of(sheet(200.0, 6, 1));
  CoatedMetal metal = painted(s, 80.0, 0.3);
  apply(metal, {s}, "scratch", {{"count", 6.0}, {"depth", 1000.0}});
  const Field<float> before = metal.coats[2].thickness;
  const double flake = 9.0;
  const ParameterValues how{{"stress", 3.2}, {"flake", flake}, {"fall", 0.5}, {"steps", 30.0}};
  const auto report = apply(metal, {s}, "peel", how);
  const Field<float>& after = metal.coats[2].thickness;
  double lost = 0.0;
  std::uint64_t fallen = 0, hanging = 0;
  Field<SpotCell> flakes(s.slot_count(), SpotCell::out);
  each_owned(s, [&](std::uint32_t slot) {
    // A cell is whole or gone.
    ASSERT_TRUE(after[slot] == before[slot] || after[slot] == 0.0f);
    lost += static_cast<double>(before[slot] - after[slot]);
    fallen += before[slot] > 0.0f && after[slot] == 0.0f;
    if (after[slot] == 0.0f || metal.coats[2].adhesion[slot] == 1.0f) return;
    ++hanging;
    flakes[slot] = SpotCell::in;
  });
  EXPECT_NEAR(report.removed, lost, 1e-6 * lost);
  EXPECT_EQ(report.cells, fallen);
  EXPECT_GT(fallen, 500u);
  EXPECT_GT(hanging, 500u);
  // What hangs on is in whole flakes, some of them side by side.
  s.links().for_each([&](std::uint32_t source, auto ghosts) {
    for (const std::uint32_t ghost : ghosts) flakes[ghost] = flakes[source];
  });
  const auto sizes = measure_spots(s, flakes).sizes;
  const double mean = static_cast<double>(hanging) / static_cast<double>(sizes.size());
  EXPECT_GT(mean, 0.5 * flake * flake);
  EXPECT_LT(mean, 4.0 * flake * flake);
}

TEST(Erode, LeavesWhatLiesBelowTheLowestCoatItWears) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  apply(metal, {s}, "age", {{"years", 5.0}, {"onset", 0.0}});
  const CoatedMetal before = metal;
  ASSERT_EQ(metal.coats[1].layer.name, "fresh rust");
  apply(metal, {s}, "erode",
        {{"depth", 1e5}, {"unevenness", 0.0}, {"into_metal", 1.0}, {"down_to", std::string("fresh rust")}});
  each_owned(s, [&](std::uint32_t slot) {
    ASSERT_GT(before.coats[1].thickness[slot], 0.0f);
    ASSERT_EQ(metal.coats[1].thickness[slot], 0.0f);
    ASSERT_EQ(metal.coats[0].thickness[slot], before.coats[0].thickness[slot]);
    ASSERT_EQ(metal.loss[slot], before.loss[slot]);
  });
  EXPECT_THROW(apply(metal, {s}, "erode", {{"down_to", std::string("glaze")}}), InputError);
}

TEST(Peel, AllThatIsLooseFallsWhenAllFlakesDo) {
  const Surface s = surface_of(sheet(200.0, 6, 1));
  CoatedMetal metal = painted(s, 80.0, 0.3);
  apply(metal, {s}, "scratch", {{"count", 40.0}, {"length", 0.05}, {"depth", 1000.0}});
  // Far more regions than flakes of that size.
  const auto report =
      apply(metal, {s}, "peel", {{"stress", 3.0}, {"steps", 6.0}, {"fall", 1.0}, {"flake", 30.0}});
  EXPECT_GT(report.cells, 100u);
  EXPECT_EQ(report.numbers.at(0).first, "loose_cells");
  EXPECT_EQ(static_cast<double>(report.cells), report.numbers[0].second);
}

TEST(Peel, SoundPaintHolds) {
  const Surface s = surface_of(sheet(100.0, 6, 1));
  CoatedMetal metal = painted(s, 80.0);
  EXPECT_EQ(apply(metal, {s}, "peel").cells, 0u);
  // A defect alone does not spread under a low stress.
  const auto report = apply(metal, {s}, "peel", {{"stress", 0.5}, {"defects", 0.002}, {"fall", 1.0}});
  EXPECT_LT(report.cells, s.owned_count() / 200);
  EXPECT_THROW(apply(metal, {s}, "peel", {{"layer", std::string("glaze")}}), InputError);
}

TEST(Dust, NoneIsLostOrMade) {
  const Surface s = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 0.02);
  CoatedMetal metal = make_coated_metal(s, find_material("copper"));
  const auto report = apply(metal, {s}, "dust", {{"amount", 8.0}});
  const auto cells = static_cast<double>(s.owned_count());
  const double lies = total(s, metal.coats.back().thickness) / cells;
  ASSERT_EQ(report.numbers[0].first, "fallen_um");
  EXPECT_NEAR(report.numbers[0].second, lies + report.numbers[1].second, 1e-4);
  EXPECT_GT(lies, 0.0);
  EXPECT_GT(report.numbers[1].second, 0.0);
  // It lies on top.
  double top = 0.0, bottom = 0.0;
  each_owned(s, [&](std::uint32_t slot) {
    const double y = s.position(slot).y, t = static_cast<double>(metal.coats.back().thickness[slot]);
    (y > 0.8 ? top : y < 0.0 ? bottom : top) += y > 0.8 || y < 0.0 ? t : 0.0;
  });
  EXPECT_GT(top, 20.0 * bottom);
}

TEST(Dust, SootSticksUnderneathTooAndOnlyWhereItIsAsked) {
  const Surface s = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 0.02);
  CoatedMetal metal = make_coated_metal(s, find_material("copper"));
  OperatorSetup setup{s};
  setup.masks = {{"where", Field<float>(s.slot_count(), 0.0f)}};
  each_owned(
      s, [&](std::uint32_t slot) { setup.masks[0].values[slot] = s.position(slot).x > 0.0 ? 1.0f : 0.0f; });
  apply(
      metal, setup, "dust",
      {{"layer", std::string("soot")}, {"colour", std::string("#201c1a")}, {"amount", 5.0}, {"cling", 1.0}});
  const Coat& soot = metal.coats.back();
  EXPECT_EQ(soot.layer.name, "soot");
  EXPECT_NEAR(static_cast<double>(soot.layer.finish.colour.r), 32.0 / 255.0, 1e-6);
  each_owned(s, [&](std::uint32_t slot) {
    const double x = s.position(slot).x;
    if (std::abs(x) > 0.1) {
      ASSERT_NEAR(static_cast<double>(soot.thickness[slot]), x > 0.0 ? 5.0 : 0.0, 0.01);
    }
  });
  EXPECT_THROW(apply(metal, setup, "dust", {{"colour", std::string("grey")}}), InputError);
  EXPECT_THROW(apply(metal, setup, "dust", {{"layer", std::string()}}), InputError);
}

TEST(Dust, LiesOnTheUppermostCoat) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  OperatorSetup setup{s};
  setup.up = {0.0, 0.0, 1.0};
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  for (const char* op : {"dust", "dust", "coat", "dust", "dust"}) apply(metal, setup, op);
  ASSERT_EQ(metal.coats.size(), 5u);
  const char* const names[] = {"dust", "paint", "dust 2"};
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(metal.coats[2 + k].layer.name, names[k]);
  const double below = total(s, metal.coats[2].thickness), above = total(s, metal.coats[4].thickness);
  EXPECT_GT(below, 0.0);
  EXPECT_NEAR(above, below, 1e-4 * below);
}

TEST(Stain, IsNoThickerThanAskedAndTheRestIsCarriedOff) {
  const Surface s = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 0.02);
  CoatedMetal metal = make_coated_metal(s, find_material("copper"));
  apply(metal, {s}, "age", {{"years", 20.0}, {"onset", 0.0}});
  const std::size_t coats = metal.coats.size();
  double carried = 0.0;
  for (int times = 0; times < 3; ++times) {
    const auto report = apply(metal, {s}, "stain", {{"amount", 6.0}, {"most", 8.0}});
    ASSERT_EQ(report.numbers.at(0).first, "carried_off");
    carried = report.numbers[0].second;
  }
  ASSERT_EQ(metal.coats.size(), coats + 1);
  float thickest = 0.0f;
  each_owned(s,
             [&](std::uint32_t slot) { thickest = std::max(thickest, metal.coats.back().thickness[slot]); });
  EXPECT_NEAR(thickest, 8.0f, 1e-4f);
  EXPECT_GT(carried, 0.0);
  EXPECT_LT(carried, 1.0);
  // Water that lays its load down sooner carries less of it away.
  EXPECT_LT(apply(metal, {s}, "stain", {{"reach", 0.05}}).numbers.at(0).second, carried);
}

TEST(Age, DryHalfTheTimeItCorrodesHalfTheYears) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal wet = make_coated_metal(s, find_material("copper")), five = wet;
  OperatorSetup setup{s};
  setup.masks = {{"wetness", Field<float>(s.slot_count(), 0.5f)}};
  EXPECT_EQ(apply(wet, setup, "age", {{"years", 10.0}, {"onset", 0.0}}).years, 10.0);
  apply(five, {s}, "age", {{"years", 5.0}, {"onset", 0.0}});
  each_owned(s, [&](std::uint32_t slot) {
    ASSERT_NEAR(wet.corroded[slot], 5.0f, 1e-5f);
    ASSERT_NEAR(wet.loss[slot], five.loss[slot], 1e-5f);
  });
}

TEST(Age, CorrodesBareMetalByItsLawsAndLeavesPaintAlone) {
  const Surface s = surface_of(sheet(80.0, 4, 1));
  CoatedMetal copper = make_coated_metal(s, find_material("copper"));
  const ParameterValues ten{{"class", std::string("C4")}, {"years", 10.0}, {"onset", 0.0}};
  apply(copper, {s}, "age", ten);
  const Material material = find_material("copper");
  const auto expect = [&](double years) {
    each_owned(s, [&](std::uint32_t slot) {
      ASSERT_NEAR(copper.loss[slot], metal_loss(material, ExposureClass::C4, years), 1e-3);
      for (std::size_t k = 0; k < 2; ++k)
        ASSERT_NEAR(copper.coats[k].thickness[slot],
                    layer_thickness(material.layers[k], ExposureClass::C4, years), 1e-3);
    });
  };
  expect(10.0);
  apply(copper, {s}, "age", ten);  // ten and ten are twenty
  expect(20.0);
  CoatedMetal steel = painted(s, 120.0);
  apply(steel, {s}, "age", ten);
  each_owned(s, [&](std::uint32_t slot) { ASSERT_EQ(steel.loss[slot], 0.0f); });
}

TEST(Age, RustStartsAtScratchesAndCreepsUnderPaint) {
  const Surface s = surface_of(sheet(150.0, 4, 1));
  CoatedMetal metal = painted(s, 240.0);
  apply(metal, {s}, "scratch", {{"count", 3.0}, {"depth", 1000.0}});
  const double bare = measure(s, metal).bare;
  ASSERT_GT(bare, 0.0);
  apply(metal, {s}, "age",
        {{"class", std::string("C5")}, {"years", 10.0}, {"spread", 0.01}, {"spots", 4000.0}});
  const CoatedNumbers numbers = measure(s, metal);
  EXPECT_GT(numbers.corroded, bare);
  EXPECT_LT(numbers.corroded, 0.9);
  // Hardly a spot comes through the paint: rust is where fronts ran from the scratches, where the metal is
  // gone deepest.
  std::vector<glm::dvec3> scratched;
  each_owned(s, [&](std::uint32_t slot) {
    if (metal.damage[slot] > 0.0f) scratched.push_back(s.position(slot));
  });
  std::uint64_t under = 0, far_off = 0;
  double loss_under = 0.0, loss_bare = 0.0;
  each_owned(s, [&](std::uint32_t slot) {
    if (metal.damage[slot] > 0.0f) loss_bare += static_cast<double>(metal.loss[slot]);
    if (!(metal.corroded[slot] >= 0.0f) || cover(metal, slot) < bare_below) return;
    ++under;
    loss_under += static_cast<double>(metal.loss[slot]);
    double nearest = 1e9;
    for (const glm::dvec3& p : scratched) nearest = std::min(nearest, glm::distance(p, s.position(slot)));
    far_off += nearest > 20.0;
  });
  EXPECT_GT(under, scratched.size());
  EXPECT_LT(far_off, under / 20);
  EXPECT_GT(loss_bare / static_cast<double>(scratched.size()), loss_under / static_cast<double>(under));
}

TEST(Operators, SameBitsFromAnyNumberOfThreads) {
  const Surface s = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 0.02);
  const auto run = [&] {
    CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
    for (const auto& [name, values] :
         std::vector<std::pair<const char*, ParameterValues>>{{"coat", {{"variation", 0.3}}},
                                                              {"scratch", {}},
                                                              {"crack", {{"spacing", 0.2}}},
                                                              {"age", {{"years", 5.0}, {"spread", 0.02}}},
                                                              {"age", {{"years", 1.0}}},
                                                              {"peel", {{"stress", 3.0}}},
                                                              {"polish", {}},
                                                              {"stain", {}},
                                                              {"dust", {}},
                                                              {"erode", {}}})
      apply(metal, {s, 7}, name, values);
    return metal;
  };
  const CoatedMetal all = run();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const CoatedMetal alone = run();
  EXPECT_EQ(all.loss, alone.loss);
  EXPECT_EQ(all.corroded, alone.corroded);
  EXPECT_EQ(all.damage, alone.damage);
  ASSERT_EQ(all.coats.size(), alone.coats.size());
  for (std::size_t k = 0; k < all.coats.size(); ++k) {
    EXPECT_EQ(all.coats[k].thickness, alone.coats[k].thickness);
    each_owned(s, [&](std::uint32_t slot) { ASSERT_GE(all.coats[k].thickness[slot], 0.0f); });
  }
}

TEST(Operators, DescribeThemselvesAndRefuseWhatTheyDoNotKnow) {
  const OperatorCatalogue catalogue = builtin_operators();
  EXPECT_EQ(catalogue.entries().size(), 9u);
  for (const OperatorEntry& entry : catalogue.entries()) {
    EXPECT_FALSE(entry.summary.empty());
    for (const ParameterInfo& p : entry.parameters) EXPECT_FALSE(p.help.empty()) << entry.name << p.name;
  }
  EXPECT_THROW(catalogue.find("gild"), InputError);
  const Surface s = surface_of(sheet(30.0, 2, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("zinc"));
  EXPECT_THROW(apply(metal, {s}, "erode", {{"deep", 3.0}}), InputError);
  EXPECT_THROW(apply(metal, {s}, "erode", {{"depth", -3.0}}), InputError);
  OperatorCatalogue open = catalogue;
  // A scene could not tell a mask from a parameter of its name.
  OperatorEntry twice = open.find("peel");
  twice.name = "peel again";
  twice.masks = {"stress"};
  EXPECT_THROW(open.add(twice), std::invalid_argument);
  EXPECT_THROW(open.add({"erode", "", {}, {}, {}, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace verdigris
