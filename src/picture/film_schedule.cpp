#include "verdigris/picture/film_schedule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "verdigris/base/error.hpp"

namespace verdigris {

std::vector<FilmMoment> film_schedule(std::span<const double> years, std::size_t frames, std::size_t hold) {
  const double total = std::accumulate(years.begin(), years.end(), 0.0);
  std::size_t stills = 2, moving = 0;
  for (const double y : years) ++(y > 0.0 ? moving : stills);
  if (moving == 0 && stills * hold == 0)
    throw InputError("frames", "nothing takes time, and nothing is held", "give hold, the frames of a still");
  if (frames < stills * hold + 2 * moving)
    throw InputError("frames",
                     fmt::format("{} are too few: {} stills stand for {} each, and {} operations take time",
                                 frames, stills, hold, moving),
                     fmt::format("give {} frames or more, or a smaller hold", stills * hold + 2 * moving));
  const std::size_t free = frames - stills * hold;

  std::vector<FilmMoment> moments(hold, FilmMoment{});
  double now = 0.0;
  std::size_t spread = 0, moved = 0;
  for (std::size_t k = 0; k < years.size(); ++k) {
    if (!(years[k] > 0.0)) {
      moments.insert(moments.end(), hold, {static_cast<double>(k + 1), now});
      continue;
    }
    // As many as its part of the years says, rounded so that they add up, and two at least.
    ++moved;
    const auto until = static_cast<std::size_t>(
        std::llround(static_cast<double>(free) * std::min(1.0, (now + years[k]) / total)));
    const std::size_t count =
        moved == moving ? free - spread
                        : std::clamp<std::size_t>(until, spread + 2, free - 2 * (moving - moved)) - spread;
    for (std::size_t i = 1; i <= count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      moments.push_back({static_cast<double>(k) + share, now + share * years[k]});
    }
    spread += count;
    now += years[k];
  }
  moments.insert(moments.end(), frames - moments.size(), {static_cast<double>(years.size()), now});
  return moments;
}

std::vector<FilmMoment> film_moments(std::span<const double> years, std::span<const double> chosen) {
  const double total = std::accumulate(years.begin(), years.end(), 0.0);
  std::vector<FilmMoment> moments;
  double last = 0.0;
  for (const double at : chosen) {
    if (!(at >= last) || at > total * (1.0 + 1e-9))
      throw InputError(
          "years",
          fmt::format("{:g} is not between the one before, {:g}, and the end, {:g}", at, last, total),
          "give ascending years of the run");
    last = at;
    double now = 0.0, place = 0.0;
    for (const double y : years) {
      if (y > 0.0 && at < (now + y) * (1.0 - 1e-9)) {
        place += std::max(0.0, (at - now) / y);
        break;
      }
      now += y;
      place += 1.0;
    }
    moments.push_back({place, std::min(at, total)});
  }
  return moments;
}

}  // namespace verdigris
