#include "verdigris/synthesis/midpoint.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>

#include "random_words.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

void check(const MidpointOptions& options) {
  if (options.levels < 1 || options.levels > 12)
    throw InputError("levels", fmt::format("{} is out of range", options.levels),
                     "give 1 to 12: 3 to 4097 points along a side");
  if (!(options.h >= 0.0 && options.h <= 1.0))
    throw InputError("h", fmt::format("{} is out of range", options.h), "give a number from 0 to 1");
}

// A displacement of deviation 1, its own for each point, level and purpose.
double deviate(const MidpointOptions& options, int column, int row, int level, std::uint32_t purpose) {
  return synthesis::random_deviate(synthesis::random_words(options.seed, static_cast<std::uint32_t>(column),
                                                           static_cast<std::uint32_t>(row),
                                                           static_cast<std::uint32_t>(level), purpose));
}
constexpr std::uint32_t corner_purpose = 0, diamond_purpose = 1, square_purpose = 2, old_purpose = 3,
                        line_purpose = 16;

// Miller's refinement: the points at the quarters of each square between old points; on a torus, the squares
// beyond the last points too.
HeightGrid quarters(const HeightGrid& old, const MidpointOptions& options, int level, double deviation) {
  HeightGrid next;
  next.side = options.tileable ? 2 * old.side : 2 * old.side - 2;
  next.heights.resize(static_cast<std::size_t>(next.side) * static_cast<std::size_t>(next.side));
  const auto wrap = [&](int k) { return k < old.side ? k : k - old.side; };
  tbb::parallel_for(0, next.side, [&](int row) {
    const int y0 = row / 2, y1 = wrap(y0 + 1), near_y = row % 2 == 0 ? 3 : 1;
    for (int column = 0; column < next.side; ++column) {
      const int x0 = column / 2, x1 = wrap(x0 + 1), near_x = column % 2 == 0 ? 3 : 1;
      const double below = near_x * old.at(x0, y0) + (4 - near_x) * old.at(x1, y0);
      const double above = near_x * old.at(x0, y1) + (4 - near_x) * old.at(x1, y1);
      next.at(column, row) = (near_y * below + (4 - near_y) * above) / 16.0 +
                             deviation * deviate(options, column, row, level, square_purpose);
    }
  });
  return next;
}

HeightGrid by_squares(const MidpointOptions& options) {
  HeightGrid grid;
  grid.side = options.tileable ? 1 : 4;
  for (int row = 0; row < grid.side; ++row)
    for (int column = 0; column < grid.side; ++column)
      grid.heights.push_back(deviate(options, column, row, 0, corner_purpose));
  // From 4 points along a side come 6, 10, 18, ...: one more than is asked for.
  double deviation = 1.0;
  for (int level = options.tileable ? 1 : 2; level <= options.levels; ++level) {
    deviation *= std::exp2(-options.h);
    grid = quarters(grid, options, level, deviation);
  }
  HeightGrid whole;
  whole.side = (1 << options.levels) + 1;
  whole.heights.reserve(static_cast<std::size_t>(whole.side) * static_cast<std::size_t>(whole.side));
  for (int row = 0; row < whole.side; ++row)
    for (int column = 0; column < whole.side; ++column)
      whole.heights.push_back(grid.at(column % grid.side, row % grid.side));
  return whole;
}

class DiamondSquare {
 public:
  explicit DiamondSquare(const MidpointOptions& options) : options_(options) {
    grid_.side = (1 << options.levels) + 1;
    grid_.heights.resize(static_cast<std::size_t>(grid_.side) * static_cast<std::size_t>(grid_.side));
    last_ = grid_.side - 1;
  }

  HeightGrid make() {
    for (const int row : {0, last_})
      for (const int column : {0, last_}) grid_.at(column, row) = moved(column, row, 0, corner_purpose, 1.0);
    double deviation = 1.0;
    for (int level = 1, step = last_; level <= options_.levels; ++level, step /= 2) {
      deviation *= std::exp2(-0.5 * options_.h);
      diamonds(step, level, deviation);
      deviation *= std::exp2(-0.5 * options_.h);
      squares(step / 2, level, deviation);
    }
    return std::move(grid_);
  }

 private:
  bool adds() const { return options_.scheme == MidpointScheme::additions; }
  int wrapped(int k) const { return options_.tileable ? k & (last_ - 1) : k; }
  // On a torus the last row and column get the displacements of the first.
  double moved(int column, int row, int level, std::uint32_t purpose, double deviation) const {
    return deviation * deviate(options_, wrapped(column), wrapped(row), level, purpose);
  }

  // The middles of squares of side `step`; before additions, their corners are old points.
  void diamonds(int step, int level, double deviation) {
    const int half = step / 2;
    tbb::parallel_for(0, last_ / step, [&](int k) {
      const int row = k * step + half;
      for (int column = half; column < last_; column += step)
        grid_.at(column, row) =
            0.25 * (grid_.at(column - half, row - half) + grid_.at(column + half, row - half) +
                    grid_.at(column - half, row + half) + grid_.at(column + half, row + half)) +
            moved(column, row, level, diamond_purpose, deviation);
    });
    if (adds())
      tbb::parallel_for(0, last_ / step + 1, [&](int k) {
        for (int column = 0; column <= last_; column += step)
          grid_.at(column, k * step) += moved(column, k * step, level, old_purpose, deviation);
      });
  }

  // The middles of edges, between corners and middles `half` away; at the border one of the four is missing.
  void squares(int half, int level, double deviation) {
    const auto is_new = [half](int column, int row) { return ((column + row) / half) % 2 != 0; };
    tbb::parallel_for(0, last_ / half + 1, [&](int k) {
      const int row = k * half;
      for (int column = is_new(0, row) ? 0 : half; column <= last_; column += 2 * half) {
        double sum = 0.0;
        int count = 0;
        const auto add = [&](int c, int r) {
          if (options_.tileable) {
            c = (c + last_) & (last_ - 1);
            r = (r + last_) & (last_ - 1);
          } else if (c < 0 || r < 0 || c > last_ || r > last_) {
            return;
          }
          sum += grid_.at(c, r);
          ++count;
        };
        add(column - half, row);
        add(column + half, row);
        add(column, row - half);
        add(column, row + half);
        grid_.at(column, row) = sum / count + moved(column, row, level, square_purpose, deviation);
      }
    });
    if (adds())
      tbb::parallel_for(0, last_ / half + 1, [&](int k) {
        const int row = k * half;
        for (int column = is_new(0, row) ? half : 0; column <= last_; column += 2 * half)
          grid_.at(column, row) += moved(column, row, level, old_purpose + 1, deviation);
      });
  }

  const MidpointOptions& options_;
  HeightGrid grid_;
  int last_ = 0;
};

}  // namespace

HeightGrid diamond_square(const MidpointOptions& options) {
  check(options);
  return options.scheme == MidpointScheme::squares ? by_squares(options) : DiamondSquare(options).make();
}

std::vector<double> midpoint_line(const MidpointOptions& options) {
  check(options);
  const int last = 1 << options.levels;
  const auto moved = [&](int k, int level, double deviation, std::uint32_t purpose) {
    return deviation * deviate(options, options.tileable ? k % last : k, 0, level, line_purpose + purpose);
  };
  std::vector<double> line(static_cast<std::size_t>(last) + 1);
  const auto at = [&](int k) -> double& { return line[static_cast<std::size_t>(k)]; };
  if (options.scheme == MidpointScheme::squares) {
    // In one dimension the quarters are those of Chaikin's corner cutting.
    std::vector<double> old;
    for (int k = 0; k < (options.tileable ? 1 : 4); ++k) old.push_back(moved(k, 0, 1.0, 0));
    double deviation = 1.0;
    for (int level = options.tileable ? 1 : 2; level <= options.levels; ++level) {
      deviation *= std::exp2(-options.h);
      std::vector<double> next(options.tileable ? 2 * old.size() : 2 * old.size() - 2);
      for (std::size_t k = 0; k < next.size(); ++k) {
        const double near = old[k / 2], far = old[(k / 2 + 1) % old.size()];
        next[k] = (k % 2 == 0 ? 0.75 * near + 0.25 * far : 0.25 * near + 0.75 * far) +
                  moved(static_cast<int>(k), level, deviation, 2);
      }
      old = std::move(next);
    }
    for (std::size_t k = 0; k < line.size(); ++k) line[k] = old[k % old.size()];
    return line;
  }
  at(0) = moved(0, 0, 1.0, 0);
  at(last) = moved(last, 0, 1.0, 0);
  // So that increments over a step and over half of it are in proportion 2^h (Fournier et al.).
  double deviation = std::sqrt(1.0 - std::exp2(2.0 * options.h - 2.0));
  if (options.h == 1.0 || options.tileable) deviation = 1.0;
  for (int level = 1, step = last; level <= options.levels; ++level, step /= 2) {
    deviation *= std::exp2(-options.h);
    for (int k = step / 2; k < last; k += step)
      at(k) = 0.5 * (at(k - step / 2) + at(k + step / 2)) + moved(k, level, deviation, 1);
    if (options.scheme == MidpointScheme::additions)
      for (int k = 0; k <= last; k += step) at(k) += moved(k, level, deviation, 3);
  }
  return line;
}

double crease(const HeightGrid& grid, int early) {
  const int step = (grid.side - 1) >> early;
  double on = 0.0, all = 0.0;
  std::size_t on_count = 0, all_count = 0;
  for (int line = 1; line + 1 < grid.side; ++line) {
    double sum = 0.0;
    for (int k = 0; k < grid.side; ++k) {
      const double column = grid.at(line - 1, k) - 2.0 * grid.at(line, k) + grid.at(line + 1, k);
      const double row = grid.at(k, line - 1) - 2.0 * grid.at(k, line) + grid.at(k, line + 1);
      sum += column * column + row * row;
    }
    all += sum;
    ++all_count;
    if (step > 0 && line % step == 0) {
      on += sum;
      ++on_count;
    }
  }
  if (on_count == 0 || all == 0.0) return 1.0;
  return on / static_cast<double>(on_count) / (all / static_cast<double>(all_count));
}

}  // namespace verdigris
