// Midpoint displacement by diamond-square (Fournier, Fussell & Carpenter 1982) makes the mountains, stream
// power erosion cuts the valleys: a point sinks with its slope and the root of the area that drains through
// it. Only
// +, -, *, / and sqrt: the same bits everywhere.

#include "terrain.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "hash.hpp"

namespace verdigris::meshes {
namespace {

constexpr int cells = 64, points = cells + 1;
constexpr double spacing = 10.0;  // m
constexpr std::uint32_t seed = 20;
constexpr int erosion_steps = 80;
constexpr double erosion = 0.11, creep_share = 0.06;  // by eye: valleys, but no rills one point wide

/// Heights in metres, row by row.
struct HeightMap {
  std::vector<double> heights = std::vector<double>(points * points);
  static bool inside(int i, int j) { return i >= 0 && j >= 0 && i < points && j < points; }
  static std::size_t index(int i, int j) { return static_cast<std::size_t>(j * points + i); }
  double& at(int i, int j) { return heights[index(i, j)]; }
};

double displacement(int i, int j, double amplitude) {
  const auto random = hash(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed);
  return amplitude * (random / 4294967296.0 * 2 - 1);
}

/// Mean of the points at (i, j) + (di, dj) and its three quarter turns that are on the map.
double mean_around(HeightMap& map, int i, int j, int di, int dj) {
  double sum = 0;
  int count = 0;
  for (const auto& [x, y] :
       {std::pair{i + di, j + dj}, {i - di, j - dj}, {i - dj, j + di}, {i + dj, j - di}}) {
    if (!HeightMap::inside(x, y)) continue;
    sum += map.at(x, y);
    ++count;
  }
  return sum / count;
}

HeightMap diamond_square() {
  HeightMap map;
  for (const int i : {0, cells / 2, cells}) {  // low corners, a high middle
    for (const int j : {0, cells / 2, cells}) {
      map.at(i, j) =
          30 + (i == cells / 2 ? 95.0 : 0.0) + (j == cells / 2 ? 70.0 : 0.0) + displacement(i, j, 40);
    }
  }
  double amplitude = 75;
  for (int step = cells / 2; step > 1; step /= 2, amplitude *= 0.5) {
    const int half = step / 2;
    for (int j = half; j < points; j += step) {
      for (int i = half; i < points; i += step) {
        map.at(i, j) = mean_around(map, i, j, half, half) + displacement(i, j, amplitude);
      }
    }
    for (int j = 0; j < points; j += half) {
      for (int i = (j / half) % 2 == 0 ? half : 0; i < points; i += step) {
        map.at(i, j) = mean_around(map, i, j, half, 0) + displacement(i, j, amplitude * 0.8);
      }
    }
  }
  return map;
}

void erode(HeightMap& map) {
  std::vector<std::size_t> order(map.heights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return map.heights[a] != map.heights[b] ? map.heights[a] > map.heights[b] : a < b;
  });
  std::vector<double> drained(map.heights.size(), 1.0);  // area in points, own and from above
  for (const std::size_t from : order) {
    const int i = static_cast<int>(from) % points, j = static_cast<int>(from) / points;
    double steepest = 0, distance = 1;
    std::size_t to = from;
    for (int dj = -1; dj <= 1; ++dj) {
      for (int di = -1; di <= 1; ++di) {
        if ((di == 0 && dj == 0) || !HeightMap::inside(i + di, j + dj)) continue;
        const double run = di != 0 && dj != 0 ? std::numbers::sqrt2 * spacing : spacing;
        const double slope = (map.heights[from] - map.at(i + di, j + dj)) / run;
        if (slope <= steepest) continue;
        steepest = slope;
        distance = run;
        to = HeightMap::index(i + di, j + dj);
      }
    }
    if (to == from) continue;
    drained[to] += drained[from];
    map.heights[from] -= std::min(erosion * std::sqrt(drained[from]) * steepest, 0.5 * steepest * distance);
  }
}

/// Soil creep: the height moves a little towards the mean of its neighbours. Fills single pits, rounds
/// ridges.
void creep(HeightMap& map) {
  HeightMap before = map;
  for (int j = 0; j < points; ++j) {
    for (int i = 0; i < points; ++i) {
      map.at(i, j) += creep_share * (mean_around(before, i, j, 1, 0) - before.at(i, j));
    }
  }
}

}  // namespace

Mesh make_terrain() {
  HeightMap map = diamond_square();
  for (int step = 0; step < erosion_steps; ++step) {
    erode(map);
    creep(map);
  }
  const double lowest = *std::min_element(map.heights.begin(), map.heights.end());
  std::vector<long> decimetres;
  for (const double height : map.heights) decimetres.push_back(std::lround((height - lowest) * 10));

  Mesh mesh;
  for (int j = 0; j < points; ++j) {
    for (int i = 0; i < points; ++i) {
      mesh.positions.emplace_back(i * spacing, static_cast<double>(decimetres[HeightMap::index(i, j)]) / 10,
                                  j * spacing);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const auto a = HeightMap::index(i, j), b = HeightMap::index(i, j + 1),
                 c = HeightMap::index(i + 1, j + 1), d = HeightMap::index(i + 1, j);
      const auto add = [&](std::size_t p, std::size_t q, std::size_t r) {
        mesh.triangles.emplace_back(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(q),
                                    static_cast<std::uint32_t>(r));
      };
      // The flatter diagonal, so that ridges and valley floors run along edges.
      if (std::abs(decimetres[a] - decimetres[c]) <= std::abs(decimetres[b] - decimetres[d])) {
        add(a, b, c);
        add(a, c, d);
      } else {
        add(a, b, d);
        add(b, c, d);
      }
    }
  }
  return mesh;
}

}  // namespace verdigris::meshes
