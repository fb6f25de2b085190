#include "verdigris/synthesis/escape_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace verdigris {

namespace {

// So many points are iterated together: the loops over them become vector instructions, each point on its
// own, so that it gets the same bits in any company.
constexpr std::size_t lanes = 16;
using Lanes = std::array<double, lanes>;

// Iterates until all have escaped; those that have stand still. `count` is the number of iterations made.
void iterate(Lanes& zx, Lanes& zy, const Lanes& cx, const Lanes& cy, const EscapeOptions& options,
             Lanes& count) {
  const double limit = options.radius * options.radius;
  constexpr int between_looks = 8;
  for (int done = 0; done < options.most_iterations;) {
    const int now = std::min(between_looks, options.most_iterations - done);
    Lanes before = count;
    for (int k = 0; k < now; ++k)
      for (std::size_t j = 0; j < lanes; ++j) {
        const double x2 = zx[j] * zx[j], y2 = zy[j] * zy[j], xy = zx[j] * zy[j];
        const bool stays = x2 + y2 <= limit;
        zx[j] = stays ? x2 - y2 + cx[j] : zx[j];
        zy[j] = stays ? xy + xy + cy[j] : zy[j];
        count[j] += stays ? 1.0 : 0.0;
      }
    done += now;
    if (before == count) return;
  }
}

// The main cardioid and the disc of period 2 make up most of the set, and need no iteration.
bool surely_inside(double x, double y) {
  const double y2 = y * y, a = x - 0.25, q = a * a + y2;
  return q * (q + a) <= 0.25 * y2 || (x + 1.0) * (x + 1.0) + y2 <= 0.0625;
}

double smooth_count(double x, double y, double count, const EscapeOptions& options) {
  const double square = x * x + y * y;
  if (square <= options.radius * options.radius) return options.most_iterations;
  // log |z| doubles with each iteration: the fraction tells by how much the point shot past the radius.
  const double past = std::log2(0.5 * std::log(square) / std::log(options.radius));
  return std::clamp(count - past, 0.0, static_cast<double>(options.most_iterations));
}

template <typename Start>
void counts_of(std::size_t size, const EscapeOptions& options, std::span<double> counts, Start&& start) {
  for (std::size_t first = 0; first < size; first += lanes) {
    Lanes zx{}, zy{}, cx{}, cy{}, count{};
    const std::size_t n = std::min(lanes, size - first);
    bool any = false;
    std::array<bool, lanes> inside{};
    for (std::size_t j = 0; j < n; ++j) {
      inside[j] = start(first + j, zx[j], zy[j], cx[j], cy[j]);
      // Known to be inside: stand still at the start, far out.
      if (inside[j]) zx[j] = 2.0 * options.radius;
      any = any || !inside[j];
    }
    for (std::size_t j = n; j < lanes; ++j) zx[j] = 2.0 * options.radius;
    if (any) iterate(zx, zy, cx, cy, options, count);
    for (std::size_t j = 0; j < n; ++j)
      counts[first + j] = inside[j] ? options.most_iterations : smooth_count(zx[j], zy[j], count[j], options);
  }
}

}  // namespace

void mandelbrot_counts(std::span<const double> x, std::span<const double> y, const EscapeOptions& options,
                       std::span<double> counts) {
  counts_of(x.size(), options, counts, [&](std::size_t k, double&, double&, double& cx, double& cy) {
    cx = x[k];
    cy = y[k];
    return surely_inside(cx, cy);
  });
}

void julia_counts(std::span<const double> x, std::span<const double> y, glm::dvec2 c,
                  const EscapeOptions& options, std::span<double> counts) {
  counts_of(x.size(), options, counts, [&](std::size_t k, double& zx, double& zy, double& cx, double& cy) {
    zx = x[k];
    zy = y[k];
    cx = c.x;
    cy = c.y;
    return false;
  });
}

bool in_mandelbrot_set(glm::dvec2 c, int most_iterations) {
  double count = 0.0;
  mandelbrot_counts({&c.x, 1}, {&c.y, 1}, {.most_iterations = most_iterations, .radius = 2.0}, {&count, 1});
  return count >= most_iterations;
}

}  // namespace verdigris
