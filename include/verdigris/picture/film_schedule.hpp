#pragma once
// When the frames of a film are taken.

#include <cstddef>
#include <span>
#include <vector>

namespace verdigris {

/// A frame: the place in a sequence of operations and the years that have passed there.
struct FilmMoment {
  double place = 0.0;  ///< 2.25: operations 0 and 1 are done, and a quarter of the years of operation 2
  double years = 0.0;  ///< since the beginning
  friend bool operator==(const FilmMoment&, const FilmMoment&) = default;
};

/// `frames` moments of operations that take so many years each. The beginning, the end and what each
/// operation that takes no time leaves stand for `hold` frames; the rest is spread evenly over the years,
/// the last of them at the end of an operation's years. Throws InputError when that leaves less than two
/// frames for each operation that takes time, and when none does and there are frames to be spread.
std::vector<FilmMoment> film_schedule(std::span<const double> years, std::size_t frames, std::size_t hold);

/// The moments of chosen years, ascending: all that happened until then has happened. Throws InputError for
/// years that are not ascending, negative or later than the end.
std::vector<FilmMoment> film_moments(std::span<const double> years, std::span<const double> chosen);

}  // namespace verdigris
