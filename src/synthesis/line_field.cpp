#include "line_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "verdigris/base/error.hpp"

namespace verdigris::synthesis {

LineField::LineField(std::span<const TurtleLine> lines, double falloff) : falloff_(falloff) {
  const LineBounds bounds = line_bounds(lines);
  const glm::dvec3 extent = bounds.upper - bounds.lower, middle = 0.5 * (bounds.lower + bounds.upper);
  const double longest = std::max({extent.x, extent.y, extent.z});
  // A margin for what lies beside the lines.
  const double scale = longest > 0.0 ? std::max(0.1, 1.0 - 2.0 * falloff) / longest : 1.0;
  if (!std::isfinite(longest) || !std::isfinite(scale))
    throw InputError("lines", fmt::format("the longest side of the drawing is {}", longest),
                     "draw with lengths that are neither tiny nor huge");
  flat_ = extent.z <= 1e-9 * longest;
  const auto placed = [&](const glm::dvec3& p) {
    const glm::dvec3 q = (p - middle) * scale + 0.5;
    return flat_ ? glm::dvec3(q.x, q.y, 0.0) : q;
  };
  for (const TurtleLine& line : lines)
    for (std::size_t k = 1; k < line.points.size(); ++k)
      segments_.push_back({placed(line.points[k - 1]), placed(line.points[k])});

  // Cubes about as large as the falloff; larger where long lines would come into too many.
  int across = static_cast<int>(std::clamp(1.0 / falloff, 4.0, flat_ ? 512.0 : 64.0));
  for (;; across /= 2) {
    bins_ = {across, across, flat_ ? 1 : across};
    std::size_t members = 0;
    for (const Segment& s : segments_) {
      const glm::ivec3 span = bin_of(glm::max(s.from, s.to)) - bin_of(glm::min(s.from, s.to)) + 1;
      members += static_cast<std::size_t>(span.x) * static_cast<std::size_t>(span.y) *
                 static_cast<std::size_t>(span.z);
    }
    if (members <= std::size_t{50'000'000} || across == 1) break;
  }
  begin_.assign(static_cast<std::size_t>(bins_.x) * static_cast<std::size_t>(bins_.y) *
                        static_cast<std::size_t>(bins_.z) +
                    1,
                0);
  for (const Segment& s : segments_) bins_of(s, [&](std::size_t bin) { ++begin_[bin + 1]; });
  for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
  members_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t k = 0; k < segments_.size(); ++k)
    bins_of(segments_[k], [&](std::size_t bin) { members_[next[bin]++] = k; });
}

glm::ivec3 LineField::bin_of(const glm::dvec3& p) const {
  const glm::dvec3 scaled = glm::clamp(p, 0.0, 1.0) * glm::dvec3(bins_);
  return glm::min(glm::ivec3(scaled), bins_ - 1);
}

std::size_t LineField::index(const glm::ivec3& bin) const {
  return (static_cast<std::size_t>(bin.z) * static_cast<std::size_t>(bins_.y) +
          static_cast<std::size_t>(bin.y)) *
             static_cast<std::size_t>(bins_.x) +
         static_cast<std::size_t>(bin.x);
}

template <typename Visit>
void LineField::bins_of(const Segment& segment, Visit&& visit) const {
  const glm::ivec3 low = bin_of(glm::min(segment.from, segment.to)),
                   high = bin_of(glm::max(segment.from, segment.to));
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) visit(index({x, y, z}));
}

double LineField::distance(const glm::dvec3& p, double most) const {
  const glm::ivec3 low = bin_of(p - most), high = bin_of(p + most);
  double best2 = most * most;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const std::size_t bin = index({x, y, z});
        for (std::uint32_t k = begin_[bin]; k < begin_[bin + 1]; ++k) {
          const Segment& s = segments_[members_[k]];
          const glm::dvec3 d = s.to - s.from, e = p - s.from;
          const double length2 = glm::dot(d, d);
          const double t = length2 > 0.0 ? std::clamp(glm::dot(e, d) / length2, 0.0, 1.0) : 0.0;
          const glm::dvec3 r = e - t * d;
          best2 = std::min(best2, glm::dot(r, r));
        }
      }
  return std::sqrt(best2);
}

void LineField::compute(const Points& points, double footprint, std::span<float> out) const {
  // A slope over two footprints at least cannot alias; wider than a tenth of the box would cost too much.
  const double falloff = std::max(falloff_, std::min(2.0 * footprint, 0.1));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const glm::dvec3 p(points.x[k], points.y.empty() ? 0.0 : points.y[k],
                       flat_ || points.z.empty() ? 0.0 : points.z[k]);
    out[k] = static_cast<float>(1.0 - distance(p, falloff) / falloff);
  }
}

}  // namespace verdigris::synthesis
