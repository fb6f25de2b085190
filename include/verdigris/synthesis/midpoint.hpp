#pragma once
// Midpoint displacement: heights refined by halving their grid, a random displacement at each new point.
// Sources: Fournier, Fussell & Carpenter 1982, "Computer rendering of stochastic models"; Miller 1986, "The
// definition and rendering of terrain maps"; Saupe 1988, "Algorithms for random fractals" (The Science of
// Fractal Images, 2.3).

#include <cstddef>
#include <cstdint>
#include <vector>

namespace verdigris {

/// How a grid is refined. What one sees of early points differs; `crease` measures it: at h = 0.8 it is 1.3,
/// 1.7 and 1.0.
enum class MidpointScheme : std::uint8_t {
  midpoints,  ///< new points between old ones, which stay: their creases are seen for ever (Fournier et al.)
  additions,  ///< all points are displaced at each level (Saupe): no point is favoured, the creases remain
  squares,    ///< no point is kept: new ones lie at the quarters of old squares, blended 9:3:3:1 (Miller)
};

struct MidpointOptions {
  int levels = 8;  ///< 1 to 12: 2^levels + 1 points along a side
  double h = 0.8;  ///< Hurst exponent, 0 to 1: displacements fall by 2^-h a level; high is smooth
  MidpointScheme scheme = MidpointScheme::squares;
  bool tileable = false;  ///< the last row and column repeat the first
  std::uint64_t seed = 1;
};

/// Heights on a square grid, row by row.
struct HeightGrid {
  int side = 0;  ///< points along a side
  std::vector<double> heights;

  double& at(int column, int row) { return heights[index(column, row)]; }
  double at(int column, int row) const { return heights[index(column, row)]; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column);
  }
};

/// Heights along a line, about fractional Brownian motion of exponent h. Displacements start at deviation 1.
/// Throws InputError for options out of range.
std::vector<double> midpoint_line(const MidpointOptions& options);

/// Heights on a square: diamonds and squares in turn (`midpoints`, `additions`), or squares alone. The same
/// bits for any number of threads.
HeightGrid diamond_square(const MidpointOptions& options);

/// How much the grid lines of the first `early` levels stand out: the mean square bend across them (second
/// difference) over that across all lines. 1 where they cannot be told apart.
double crease(const HeightGrid& grid, int early = 3);

}  // namespace verdigris
