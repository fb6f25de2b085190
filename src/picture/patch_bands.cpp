// Every band is a quadrilateral with two parallel sides (a triangle at C), cut by walking along both of them
// from left to right, always over the shorter of the two possible diagonals. A triangle then has two corners
// on one side and one on the other, so none can be flat. Contour points on the oblique ends belong to the
// upper side: each is joined to a centre below it, however far the end leans.
#include "verdigris/picture/patch_bands.hpp"

#include <algorithm>
#include <cmath>

namespace verdigris {

void band_lines(const Outline& outline, double cell_size, std::span<const ColumnRun> owned,
                std::vector<BandLine>& lines) {
  constexpr double least_gap =
      1e-4;  // cells; a nearer centre would only make a needle beside its contour point
  // Rows rise along AC from A and along BC from B; a line is used when both its ends are points of their own.
  std::size_t r = 0;
  for (std::size_t l = 0; l < outline.ac.size(); ++l) {
    const std::int32_t row = outline.ac[l].row;
    if (row < 0) continue;
    while (r < outline.bc.size() && outline.bc[r].row < row) ++r;
    if (r == outline.bc.size()) break;
    if (outline.bc[r].row != row) continue;
    const double left = outline.ac[l].p.x / cell_size - 0.5, right = outline.bc[r].p.x / cell_size - 0.5;
    ColumnRun columns{static_cast<std::int32_t>(std::floor(left + least_gap)) + 1,
                      static_cast<std::int32_t>(std::ceil(right - least_gap))};
    const ColumnRun limit =
        static_cast<std::size_t>(row) < owned.size() ? owned[static_cast<std::size_t>(row)] : ColumnRun{};
    columns.begin = std::max(columns.begin, limit.begin);
    columns.end = std::max(columns.begin, std::min(columns.end, limit.end));
    lines.push_back({row, static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(r), columns});
  }
}

namespace {

struct ChainPoint {
  double along;  // x; y where the oblique sides are walked instead
  std::uint32_t vertex;
  double across = 0.0;  // y of points on oblique sides
};
using Chain = std::vector<ChainPoint>;

class BandWriter {
 public:
  explicit BandWriter(BandIndices& indices) : indices_(indices) {}

  Chain lower, upper;   // along x
  Chain left, right;    // bottom up, without the corners
  double height = 0.0;  // y of the lower side

  void band() {
    if (lower.size() == 2 && upper.size() == 1) return triangle();
    if (lower.size() > 2 && !(left.empty() && right.empty())) return leaning();
    walk();
    std::size_t begin = 0, end = steps_.size();
    if (!left.empty()) {
      const std::uint32_t pivot = steps_[0] ? upper[1].vertex : lower[1].vertex;
      open_fan(pivot, upper.front().vertex);
      for (std::size_t k = left.size(); k-- > 0;) indices_.fans.push_back(left[k].vertex);
      indices_.fans.push_back(lower.front().vertex);
      begin = 1;
    }
    if (!right.empty()) --end;
    encode(begin, end);
    if (!right.empty()) {
      open_fan(steps_.back() ? upper[upper.size() - 2].vertex : lower[lower.size() - 2].vertex,
               lower.back().vertex);
      for (const ChainPoint& p : right) indices_.fans.push_back(p.vertex);
      indices_.fans.push_back(upper.back().vertex);
    }
  }

 private:
  // The oblique ends go over to the upper side. Both sides then begin and end in one point: a triangle at
  // each end.
  void leaning() {
    const std::uint32_t first = lower.front().vertex, last = lower.back().vertex;
    lower.erase(lower.begin());
    lower.pop_back();
    upper.insert(upper.begin(), left.begin(), left.end());
    upper.insert(upper.end(), right.rbegin(), right.rend());
    open_fan(upper.front().vertex, first);
    indices_.fans.push_back(lower.front().vertex);
    const std::uint32_t last_upper = upper.back().vertex, last_lower = lower.back().vertex;
    walk();
    encode(0, steps_.size());
    open_fan(last_upper, last_lower);
    indices_.fans.push_back(last);
  }

  // The band is a triangle without points on its lower side: its two oblique sides are walked instead, bottom
  // up.
  void triangle() {
    const std::uint32_t apex = upper[0].vertex, start = lower[0].vertex, end = lower[1].vertex;
    if (left.empty()) {
      open_fan(start, end);
      for (const ChainPoint& p : right) indices_.fans.push_back(p.vertex);
      indices_.fans.push_back(apex);
    } else if (right.empty()) {
      open_fan(end, apex);
      for (std::size_t k = left.size(); k-- > 0;) indices_.fans.push_back(left[k].vertex);
      indices_.fans.push_back(start);
    } else {
      std::swap(lower, right);
      std::swap(upper, left);
      for (Chain* side : {&lower, &upper})
        for (ChainPoint& p : *side) p.along = p.across;
      lower.insert(lower.begin(), {height, end});
      upper.insert(upper.begin(), {height, start});
      const std::uint32_t last_left = upper.back().vertex, last_right = lower.back().vertex;
      walk();
      encode(0, steps_.size());
      open_fan(last_right, apex);
      indices_.fans.push_back(last_left);
    }
  }

  void walk() {
    steps_.clear();
    std::size_t i = 0, j = 0;
    while (i + 1 < lower.size() || j + 1 < upper.size()) {
      bool up;
      if (i + 1 == lower.size())
        up = true;
      else if (j + 1 == upper.size())
        up = false;
      else
        up = std::abs(upper[j + 1].along - lower[i].along) <= std::abs(lower[i + 1].along - upper[j].along);
      steps_.push_back(up);
      ++(up ? j : i);
    }
  }

  // Steps that alternate are a strip, those that stay on one side a fan about the point they see on the
  // other.
  void encode(std::size_t begin, std::size_t end) {
    std::size_t i = 0, j = 0;
    for (std::size_t k = 0; k < begin; ++k) ++(steps_[k] ? j : i);
    for (std::size_t k = begin; k < end;) {
      std::size_t run = 1;
      while (k + run < end && steps_[k + run] == steps_[k]) ++run;
      if (!steps_[k]) {
        open_fan(upper[j].vertex, lower[i].vertex);
        for (std::size_t n = 1; n <= run; ++n) indices_.fans.push_back(lower[i + n].vertex);
        i += run;
      } else if (run > 1) {
        open_fan(lower[i].vertex, upper[j + run].vertex);
        for (std::size_t n = run; n-- > 0;) indices_.fans.push_back(upper[j + n].vertex);
        j += run;
      } else {  // a strip begins on the upper side, or its triangles would be clockwise
        std::vector<std::uint32_t>& strips = indices_.strips;
        if (!strips.empty()) strips.push_back(BandIndices::restart);
        strips.push_back(upper[j].vertex);
        strips.push_back(lower[i].vertex);
        bool up = true;
        for (run = 0; k + run < end && steps_[k + run] == up; ++run, up = !up)
          strips.push_back(up ? upper[++j].vertex : lower[++i].vertex);
      }
      k += run;
    }
  }

  // Goes on with the fan before if this one turns on about the same point.
  void open_fan(std::uint32_t pivot, std::uint32_t first) {
    std::vector<std::uint32_t>& fans = indices_.fans;
    if (pivot == pivot_ && fan_ < fans.size() && fans.back() == first) return;
    if (!fans.empty()) fans.push_back(BandIndices::restart);
    fan_ = fans.size();
    pivot_ = pivot;
    fans.push_back(pivot);
    fans.push_back(first);
  }

  BandIndices& indices_;
  std::vector<std::uint8_t> steps_;  // 1: on the upper side
  std::size_t fan_ = ~std::size_t{0};
  std::uint32_t pivot_ = BandIndices::restart;
};

}  // namespace

void triangulate_bands(const Frame& frame, double cell_size, const Outline& outline,
                       std::span<const BandLine> lines, std::span<const std::uint32_t> line_vertex,
                       std::size_t first, std::size_t last, std::uint32_t base, BandIndices& indices) {
  if (!(frame.cy > 0.0)) return;
  const std::uint32_t ab = base + 3, bc = ab + static_cast<std::uint32_t>(outline.ab.size());
  const std::uint32_t ac = bc + static_cast<std::uint32_t>(outline.bc.size());
  // Line -1 is AB, the line after the last is C.
  const auto chain = [&](std::size_t band_end, Chain& points) {
    points.clear();
    if (band_end == 0) {
      points.push_back({0.0, base});
      for (std::uint32_t k = 0; k < outline.ab.size(); ++k) points.push_back({outline.ab[k].p.x, ab + k});
      points.push_back({frame.ab, base + 1});
    } else if (band_end > lines.size()) {
      points.push_back({frame.cx, base + 2});
    } else {
      const BandLine& line = lines[band_end - 1];
      points.push_back({outline.ac[line.left].p.x, ac + line.left});
      std::uint32_t vertex = line_vertex[band_end - 1];
      for (std::int32_t i = line.columns.begin; i < line.columns.end; ++i)
        points.push_back({(i + 0.5) * cell_size, vertex++});
      points.push_back({outline.bc[line.right].p.x, bc + line.right});
    }
  };
  const auto between = [&](std::size_t k, const std::vector<OutlinePoint>& side, std::uint32_t BandLine::*end,
                           std::uint32_t offset, Chain& points) {
    points.clear();
    const std::size_t from = k == 0 ? 0 : lines[k - 1].*end + 1u;
    const std::size_t to = k == lines.size() ? side.size() : lines[k].*end;
    for (std::size_t n = from; n < to; ++n)
      points.push_back({side[n].p.x, offset + static_cast<std::uint32_t>(n), side[n].p.y});
  };
  BandWriter writer(indices);
  for (std::size_t k = first; k < last; ++k) {
    writer.height = k == 0 ? 0.0 : (lines[k - 1].row + 0.5) * cell_size;
    chain(k, writer.lower);
    chain(k + 1, writer.upper);
    between(k, outline.ac, &BandLine::left, ac, writer.left);
    between(k, outline.bc, &BandLine::right, bc, writer.right);
    writer.band();
  }
}

std::vector<std::uint32_t> triangles_of(const BandIndices& indices) {
  std::vector<std::uint32_t> triangles;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < indices.strips.size(); ++k) {
    const auto& s = indices.strips;
    if (s[k] == BandIndices::restart) {
      begin = k + 1;
    } else if (k >= begin + 2) {
      const bool odd = (k - begin) % 2 != 0;
      triangles.insert(triangles.end(), {s[odd ? k - 1 : k - 2], s[odd ? k - 2 : k - 1], s[k]});
    }
  }
  begin = 0;
  for (std::size_t k = 0; k < indices.fans.size(); ++k) {
    const auto& f = indices.fans;
    if (f[k] == BandIndices::restart)
      begin = k + 1;
    else if (k >= begin + 2)
      triangles.insert(triangles.end(), {f[begin], f[k - 1], f[k]});
  }
  return triangles;
}

}  // namespace verdigris
