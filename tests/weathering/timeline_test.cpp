// Timelines: order, expressions of masks, what is refused.
#include "verdigris/weathering/timeline.hpp"

#include "sheets.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/picture/coat_picture.hpp"

namespace verdigris {
namespace {

using namespace sheets;

std::vector<TimelineRecord> run(const Surface& s, CoatedMetal& metal, const std::vector<TimelineStep>& steps,
                                const TimelineListener& listener = {}) {
  Field<float> half(s.slot_count(), 0.0f);
  each_owned(s, [&](std::uint32_t slot) { half[slot] = s.position(slot).x < 30.0 ? 1.0f : 0.0f; });
  SourceMasks sources(s, "z", 1);
  MaskBook masks(sources, {{"half", half}});
  return run_timeline(builtin_operators(), s, metal, steps, masks, 5, listener);
}

const TimelineStep paint{"coat", {{"thickness", 40.0}, {"variation", 0.0}}, ""};
const TimelineStep wear{"erode", {{"depth", 15.0}, {"unevenness", 0.0}}, ""};

TEST(Timeline, OperationsFollowEachOther) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  auto records = run(s, metal, {paint, wear, wear});
  ASSERT_EQ(records.size(), 3u);
  EXPECT_NEAR(records[0].numbers.coats[2], 40.0, 1e-4);
  EXPECT_NEAR(records[1].numbers.coats[2], 25.0, 1e-4);
  EXPECT_NEAR(records[2].numbers.coats[2], 10.0, 1e-4);
  // The other way round there is nothing to wear.
  metal = make_coated_metal(s, find_material("bare-steel"));
  EXPECT_NEAR(run(s, metal, {wear, wear, paint}).back().numbers.coats[2], 40.0, 1e-4);
  // Years add up.
  metal = make_coated_metal(s, find_material("copper"));
  records = run(s, metal, {{"age", {{"years", 2.0}}, ""}, {"dust", {}, ""}, {"age", {{"years", 3.0}}, ""}});
  EXPECT_EQ(records[2].years, 5.0);
  // The second of two equal operations has random numbers of its own.
  metal = make_coated_metal(s, find_material("bare-steel"));
  const TimelineStep scratch{"scratch", {{"count", 3.0}}, ""};
  records = run(s, metal, {paint, scratch, scratch});
  EXPECT_GT(records[2].numbers.bare, 1.2 * records[1].numbers.bare);
}

TEST(Timeline, MasksAreFormulasOfTheSurfaceAndItsState) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  TimelineStep coat = paint;
  coat.values.emplace_back("where", "half * facing");
  TimelineStep second{"coat", {{"layer", "lacquer"}, {"variation", 0.0}, {"where", "1 - bare"}}, ""};
  run(s, metal, {coat, second});
  each_owned(s, [&](std::uint32_t slot) {
    const bool left = s.position(slot).x < 30.0;
    ASSERT_NEAR(metal.coats[2].thickness[slot], left ? 40.0 : 0.0, 1e-3);
    ASSERT_NEAR(metal.coats[3].thickness[slot], left ? 60.0 : 0.0, 1e-3);
  });
}

// Metal lost, years corroded and coats of owned cells.
std::vector<float> content(const Surface& s, const CoatedMetal& metal) {
  std::vector<float> all;
  each_owned(s, [&](std::uint32_t slot) {
    all.insert(all.end(), {metal.loss[slot], metal.corroded[slot]});
    for (const Coat& coat : metal.coats) all.push_back(coat.thickness[slot]);
  });
  return all;
}

TEST(Timeline, ShowsItsMomentsAsRunsThatEndThere) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  for (const double spread : {0.0, 0.2}) {
    const auto age = [&](double years) {
      return TimelineStep{"age", {{"years", years}, {"spread", spread}, {"spots", 4.0}, {"onset", 1.0}}, ""};
    };
    std::vector<std::vector<float>> shown;
    TimelineListener listener;
    listener.moments = {0.0, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0};
    listener.at = [&](std::size_t k, const CoatedMetal& metal) {
      ASSERT_EQ(k, shown.size());
      shown.push_back(content(s, metal));
    };
    CoatedMetal metal = make_coated_metal(s, find_material("copper"));
    const std::vector<TimelineStep> steps{paint, age(8.0), wear};
    EXPECT_EQ(timeline_years(builtin_operators(), steps), (std::vector<double>{0.0, 8.0, 0.0}));
    run(s, metal, steps, listener);
    ASSERT_EQ(shown.size(), 7u);
    EXPECT_EQ(shown[6], content(s, metal));
    EXPECT_EQ(shown[5], shown[6]);  // wear takes no time
    CoatedMetal early = make_coated_metal(s, find_material("copper"));
    EXPECT_EQ(shown[0], content(s, early));
    run(s, early, {paint});
    EXPECT_EQ(shown[1], content(s, early));
    // Watching changes nothing.
    CoatedMetal unseen = make_coated_metal(s, find_material("copper"));
    run(s, unseen, steps);
    EXPECT_EQ(content(s, unseen), content(s, metal));
    for (const std::size_t k : {2u, 3u, 4u}) {
      CoatedMetal until = make_coated_metal(s, find_material("copper"));
      run(s, until, {paint, age(2.0 * static_cast<double>(k == 4 ? 4 : k - 1))});
      std::size_t differing = 0;
      const std::vector<float> ended = content(s, until);
      for (std::size_t i = 0; i < ended.size(); ++i) differing += std::abs(ended[i] - shown[k][i]) > 1e-3f;
      EXPECT_EQ(differing, 0u) << spread << " " << k;
    }
  }
}

TEST(Timeline, NumbersAreParametersAndTextsOfMasksFormulas) {
  const Surface s = surface_of(sheet(100.0, 6, 1));
  const auto fallen = [&](double stress, const char* where) {
    CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
    const TimelineStep scratch{"scratch", {{"count", 6.0}, {"depth", 1000.0}}, ""};
    const auto records = run(
        s, metal,
        {paint, scratch, {"peel", {{"stress", stress}, {"fall", 1.0}, {"where", std::string(where)}}, ""}});
    return records.back().report.cells;
  };
  EXPECT_LT(fallen(2.0, "1"), fallen(3.0, "1"));
  EXPECT_LT(fallen(3.0, "1"), fallen(4.0, "1"));
  EXPECT_EQ(fallen(4.0, "0.5"), fallen(2.0, "1"));
}

TEST(Timeline, StopsWhenTold) {
  const Surface s = surface_of(sheet(60.0, 4, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  const auto records = run(s, metal, {paint, {"age", {{"years", 9.0}, {"spread", 1.0}}, ""}, wear},
                           {[](std::size_t step, double share) { return step == 0 || share < 0.5; }});
  ASSERT_EQ(records.size(), 2u);
  EXPECT_FALSE(records[1].report.complete);
  EXPECT_GT(records[1].years, 0.0);
  EXPECT_LT(records[1].years, 9.0);
}

void expect_refused(const TimelineStep& step, const char* part) {
  const std::vector<std::string> names = mask_book_names({});
  try {
    check_timeline(builtin_operators(), std::vector{step}, names);
    FAIL() << "accepted " << step.op;
  } catch (const InputError& error) {
    EXPECT_NE(error.where().find("scene.toml:7"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Timeline, RefusesWhatItDoesNotKnow) {
  const std::string where = "scene.toml:7";
  expect_refused({"gild", {}, where}, "gild");
  expect_refused({"coat", {{"thicknes", 3.0}}, where}, "thicknes");
  expect_refused({"coat", {{"thickness", -3.0}}, where}, "out of range");
  expect_refused({"age", {{"class", "C9"}}, where}, "C9");
  expect_refused({"polish", {{"where", "convex *"}}, where}, "polish.where");
  expect_refused({"polish", {{"where", "shiny"}}, where}, "shiny");
  check_timeline(builtin_operators(),
                 std::vector{TimelineStep{"polish", {{"where", "2 * convex - bare"}}, ""}},
                 mask_book_names({}));
}

TEST(CoatPicture, HoldsTheUppermostFirstAndJoinsWhatLooksAlike) {
  const Surface s = surface_of(sheet(30.0, 2, 1));
  CoatedMetal metal = make_coated_metal(s, find_material("bare-steel"));
  run(s, metal, {paint});
  CoatPicture picture = picture_of(s, metal);
  ASSERT_EQ(picture.stack.layers.size(), 1u);  // no rust yet
  const std::uint32_t slot = s.rows()[s.row_begin(0) + 3].run_begin;
  EXPECT_EQ(picture.cells[slot].depth[0], LayerCell::packed(optical_depth(picture.stack.layers[0], 40.0f)));
  // Six coats, two of one finish: four are drawn, and the rust below the paint does not shine through.
  metal.coats[0].thickness[slot] = metal.coats[1].thickness[slot] = 30.0f;
  Coat stain = metal.coats[1];
  stain.kind = CoatKind::loose;
  stain.layer.name += " stain";
  std::fill(stain.thickness.begin(), stain.thickness.end(), 0.0f);
  metal.coats.push_back(stain);
  metal.coats.back().thickness[slot + 1] = 4.0f;
  run(s, metal, {{"coat", {{"layer", "lacquer"}, {"thickness", 1.0}}, ""}, {"dust", {}, ""}});
  ASSERT_EQ(metal.coats.size(), 6u);
  picture = picture_of(s, metal);
  EXPECT_EQ(picture.stack.layers.size(), most_layers);
  EXPECT_EQ(coat_heights(s, metal)[slot] > 99.0f, true);
}

}  // namespace
}  // namespace verdigris
