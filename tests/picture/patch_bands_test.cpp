// One triangle in its plane: the bands must cover it exactly, whatever its shape and the size of the cells.
#include "verdigris/picture/patch_bands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "verdigris/picture/contour.hpp"

namespace verdigris {
namespace {

Frame plane_frame(double ab, double cx, double cy) {
  return {glm::dvec3(0.0), {1, 0, 0}, {0, 1, 0}, ab, cx, cy, 0};
}

std::vector<OutlinePoint> side(glm::dvec2 from, glm::dvec2 to, double h, const EdgeInPlane* across) {
  const EdgeInPlane edge{from, to};
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  std::vector<ContourPoint> points;
  edge_contour(edge, across, length, h, points);
  std::vector<OutlinePoint> result;
  for (const ContourPoint& p : points) result.push_back({from + p.t * (to - from), p.row});
  return result;
}

struct Bands {
  std::vector<glm::dvec2> points;
  std::vector<std::uint32_t> triangles;
  std::size_t lines = 0, centres = 0;
};

// `across`: the three edges in the grids of made-up neighbours, or null.
Bands make(const Frame& f, double h, const std::array<EdgeInPlane, 3>* across = nullptr) {
  Outline outline{side(f.corner(0), f.corner(1), h, across ? &(*across)[0] : nullptr),
                  side(f.corner(1), f.corner(2), h, across ? &(*across)[1] : nullptr),
                  side(f.corner(0), f.corner(2), h, across ? &(*across)[2] : nullptr)};
  Bands bands;
  bands.points = {f.corner(0), f.corner(1), f.corner(2)};
  for (const auto* points : {&outline.ab, &outline.bc, &outline.ac})
    for (const OutlinePoint& p : *points) bands.points.push_back(p.p);
  const std::vector<ColumnRun> anything(static_cast<std::size_t>(f.cy / h) + 2, ColumnRun{-1000000, 1000000});
  std::vector<BandLine> lines;
  band_lines(outline, h, anything, lines);
  std::vector<std::uint32_t> first;
  for (const BandLine& line : lines) {
    first.push_back(static_cast<std::uint32_t>(bands.points.size()));
    for (std::int32_t i = line.columns.begin; i < line.columns.end; ++i) {
      bands.points.push_back({(i + 0.5) * h, (line.row + 0.5) * h});
      ++bands.centres;
    }
  }
  bands.lines = lines.size();
  BandIndices indices;
  triangulate_bands(f, h, outline, lines, first, 0, lines.size() + 1, 0, indices);
  bands.triangles = triangles_of(indices);
  return bands;
}

double area(const Bands& b, std::size_t t) {
  const glm::dvec2 p = b.points[b.triangles[t]], q = b.points[b.triangles[t + 1]] - p,
                   r = b.points[b.triangles[t + 2]] - p;
  return 0.5 * (q.x * r.y - q.y * r.x);
}

// Same orientation, equal area in all, and every inner edge used once each way: then nothing overlaps.
void expect_exact_cover(const Bands& b, const Frame& f) {
  const double whole = 0.5 * f.ab * f.cy;
  double sum = 0.0, least = 1e300;
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < b.triangles.size(); t += 3) {
    const double a = area(b, t);
    least = std::min(least, a);
    sum += a;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{b.triangles[t + k], b.triangles[t + (k + 1) % 3]}];
  }
  ASSERT_NEAR(sum / whole, 1.0, 1e-9);
  ASSERT_GT(least, 0.0);
  std::size_t open = 0;
  std::vector<bool> used(b.points.size(), false);
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    open += edges.count({edge.second, edge.first}) == 0;
    used[edge.first] = true;
  }
  ASSERT_EQ(open, b.points.size() - b.centres);  // the contour and nothing else
  ASSERT_EQ(std::count(used.begin(), used.end(), false), 0);
}

TEST(PatchBands, RightTriangleThroughCentres) {
  // All three edges meet cell centres or run between them: BC passes exactly through the centres of the
  // diagonal.
  const Frame f = plane_frame(8.0, 0.0, 8.0);
  const Bands b = make(f, 1.0);
  expect_exact_cover(b, f);
  EXPECT_EQ(b.lines, 8u);
  EXPECT_EQ(b.centres, 28u);  // 7 + 6 + ... + 0 strictly inside, the 8 on the diagonal are contour points
}

TEST(PatchBands, CellsLargerThanTheTriangle) {
  const Frame f = plane_frame(1.0, 0.3, 0.4);
  const Bands b = make(f, 10.0);
  expect_exact_cover(b, f);
  EXPECT_EQ(b.triangles.size(), 3u);
}

TEST(PatchBands, NothingForNoArea) {
  EXPECT_TRUE(make(plane_frame(5.0, 2.0, 0.0), 1.0).triangles.empty());
}

TEST(PatchBands, RandomTrianglesAreCoveredExactly) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 6000; ++n) {
    // From needles of 1e-5 to right angles, from cells of 20 triangles to 100 cells a side, at any scale.
    const double scale = std::pow(10.0, 8.0 * unit(random) - 4.0);
    const double ab = scale, cx = n % 5 == 0 ? 0.0 : ab * unit(random);
    const double highest = std::min(std::sqrt(ab * ab - cx * cx), std::sqrt(ab * ab - (ab - cx) * (ab - cx)));
    const double cy = std::max(highest, 1e-3 * ab) * std::pow(10.0, n % 3 == 0 ? -5.0 * unit(random) : 0.0);
    const double h = ab / std::pow(10.0, 3.3 * unit(random) - 1.3);
    const Frame f = plane_frame(ab, cx, cy);
    std::array<EdgeInPlane, 3> across;
    for (int k = 0; k < 3; ++k) {  // each edge as a neighbour's grid, turned and shifted, would see it
      const auto e = static_cast<std::size_t>(k);
      const double a = 6.3 * unit(random);
      const Motion motion{std::cos(a), std::sin(a), h * unit(random), h * unit(random)};
      across[e] = k == 2 ? EdgeInPlane{motion(f.corner(0)), motion(f.corner(2))}
                         : EdgeInPlane{motion(f.corner(k)), motion(f.corner(k + 1))};
    }
    SCOPED_TRACE(testing::Message() << "ab " << ab << " cx " << cx << " cy " << cy << " h " << h);
    expect_exact_cover(make(f, h, n % 2 ? &across : nullptr), f);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(PatchBands, BothSidesOfAnEdgeSeeTheSamePoints) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 2000; ++n) {
    const auto end = [&] { return glm::dvec2(10.0 * unit(random), n % 4 == 0 ? 2.5 : 10.0 * unit(random)); };
    const EdgeInPlane a{end(), end()}, b{end(), end()};
    const double length = std::hypot(a.to.x - a.from.x, a.to.y - a.from.y);
    std::vector<ContourPoint> here, there;
    edge_contour(a, &b, length, 0.37, here);
    edge_contour(b, &a, length, 0.37, there);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); ++k) {
      ASSERT_EQ(here[k].t, there[k].t);
      ASSERT_GT(here[k].t, k > 0 ? here[k - 1].t : 0.0);
    }
  }
}

}  // namespace
}  // namespace verdigris
