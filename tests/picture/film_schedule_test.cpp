// When frames are taken.
#include "verdigris/picture/film_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

TEST(FilmSchedule, SpreadsFramesOverYearsAndHoldsStills) {
  const std::vector<double> years{0.0, 10.0, 0.0, 30.0};
  const auto film = film_schedule(years, 56, 4);
  ASSERT_EQ(film.size(), 56u);
  EXPECT_TRUE(std::is_sorted(film.begin(), film.end(),
                             [](const auto& a, const auto& b) { return a.place < b.place; }));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(film[k], (FilmMoment{0.0, 0.0}));
    EXPECT_EQ(film[4 + k], (FilmMoment{1.0, 0.0}));
    EXPECT_EQ(film[18 + k], (FilmMoment{3.0, 10.0}));
    EXPECT_EQ(film[52 + k], (FilmMoment{4.0, 40.0}));
  }
  for (std::size_t k = 0; k < 10; ++k) EXPECT_NEAR(film[8 + k].years, 1.0 * static_cast<double>(k + 1), 1e-9);
  for (std::size_t k = 0; k < 30; ++k) EXPECT_NEAR(film[22 + k].years, 11.0 + static_cast<double>(k), 1e-9);
}

TEST(FilmSchedule, GivesShortOperationsTwoFrames) {
  const std::vector<double> years{0.001, 50.0, 0.001, 0.001};
  const auto film = film_schedule(years, 40, 0);
  ASSERT_EQ(film.size(), 40u);
  for (int k = 0; k < 4; ++k)
    EXPECT_GE(std::count_if(film.begin(), film.end(),
                            [&](const FilmMoment& m) { return m.place > k && m.place <= k + 1; }),
              2);
  EXPECT_EQ(film.back().place, 4.0);
}

TEST(FilmSchedule, SaysWhenFramesDoNotDo) {
  const std::vector<double> one{5.0}, none{0.0, 0.0};
  EXPECT_THROW(film_schedule(one, 25, 12), InputError);
  EXPECT_EQ(film_schedule(one, 26, 12).size(), 26u);
  EXPECT_THROW(film_schedule(none, 10, 0), InputError);
  EXPECT_EQ(film_schedule(none, 40, 10).size(), 40u);
}

TEST(FilmSchedule, ShowsAllThatHasHappenedByAChosenYear) {
  const std::vector<double> years{0.0, 10.0, 0.0, 30.0, 0.0};
  const auto film = film_moments(years, std::vector<double>{0.0, 2.5, 10.0, 25.0, 40.0});
  EXPECT_EQ(film[0], (FilmMoment{1.0, 0.0}));
  EXPECT_EQ(film[1], (FilmMoment{1.25, 2.5}));
  EXPECT_EQ(film[2], (FilmMoment{3.0, 10.0}));
  EXPECT_EQ(film[3], (FilmMoment{3.5, 25.0}));
  EXPECT_EQ(film[4], (FilmMoment{5.0, 40.0}));
  // Sums that are not round.
  EXPECT_EQ(film_moments(std::vector<double>{0.1, 0.2, 0.0}, std::vector<double>{0.3})[0].place, 3.0);
  EXPECT_THROW(film_moments(years, std::vector<double>{1.0, 0.5}), InputError);
  EXPECT_THROW(film_moments(years, std::vector<double>{41.0}), InputError);
  EXPECT_THROW(film_moments(years, std::vector<double>{-1.0}), InputError);
}

}  // namespace
}  // namespace verdigris
