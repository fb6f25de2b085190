#include "verdigris/synthesis/function_system.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <queue>

#include "random_words.hpp"

namespace verdigris {

namespace {

constexpr std::size_t chain_length = 1024;
// A search for a distance looks at a hundred images or so, 25,000 at worst round a fern; at more only where
// images overlap almost wholly.
constexpr int most_images = 40'000;
constexpr std::uint32_t chaos_purpose = 0x1F5u;

// Where a map leaves a point alone; contractions have one such point.
glm::dvec3 fixed_point(const AffineMap& map) {
  return glm::inverse(glm::dmat3(1.0) - map.linear) * map.offset;
}

AffineMap after(const AffineMap& outer, const AffineMap& inner) {
  return {outer.linear * inner.linear, outer(inner.offset), 1.0};
}

}  // namespace

double stretch(const glm::dmat3& linear) {
  // Root of the greatest eigenvalue of the symmetric matrix s = m^T m, by its characteristic cubic.
  const glm::dmat3 s = glm::transpose(linear) * linear;
  const double q = (s[0][0] + s[1][1] + s[2][2]) / 3.0;
  const glm::dmat3 b = s - glm::dmat3(q);
  double squares = 0.0;
  for (int k = 0; k < 3; ++k) squares += glm::dot(b[k], b[k]);
  const double p = std::sqrt(squares / 6.0);
  if (p < 1e-15 * q || p == 0.0) return std::sqrt(q);
  const double r = std::clamp(0.5 * glm::determinant(b) / (p * p * p), -1.0, 1.0);
  return std::sqrt(std::max(0.0, q + 2.0 * p * std::cos(std::acos(r) / 3.0)));
}

Ball attractor_ball(const FunctionSystem& system) {
  // The middle of a sample's box is a good centre.
  glm::dvec3 low = fixed_point(system.maps[0]), high = low;
  for (const glm::dvec3& p : chaos_game(system, 4 * chain_length, 1)) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::dvec3 centre = 0.5 * (low + high);
  double rough = 0.0;
  for (const AffineMap& map : system.maps)
    rough = std::max(rough, glm::distance(map(centre), centre) / (1.0 - stretch(map.linear)));

  // Images of the rough ball cover the attractor: split the one that reaches farthest until it is small.
  struct Image {
    AffineMap map;
    double reach, radius;
    bool operator<(const Image& other) const { return reach < other.reach; }
  };
  const auto image = [&](const AffineMap& map) {
    const double radius = stretch(map.linear) * rough;
    return Image{map, glm::distance(map(centre), centre) + radius, radius};
  };
  std::priority_queue<Image> images;
  images.push(image({}));
  for (int splits = 0; splits < 2000 && images.top().radius > 1e-4 * rough; ++splits) {
    const AffineMap outer = images.top().map;
    images.pop();
    for (const AffineMap& map : system.maps) images.push(image(after(outer, map)));
  }
  return {centre, images.top().reach};
}

std::vector<glm::dvec3> chaos_game(const FunctionSystem& system, std::size_t count, std::uint64_t seed) {
  std::vector<double> up_to;
  double total = 0.0;
  for (const AffineMap& map : system.maps) up_to.push_back(total += map.weight);
  std::vector<glm::dvec3> points(count);
  const glm::dvec3 start = fixed_point(system.maps[0]);
  tbb::parallel_for(std::size_t{0}, (count + chain_length - 1) / chain_length, [&](std::size_t chain) {
    glm::dvec3 p = start;
    std::array<std::uint32_t, 4> words{};
    const std::size_t first = chain * chain_length, last = std::min(count, first + chain_length);
    // The start is in the attractor; some steps make chains forget it.
    constexpr std::size_t warm_up = 32;
    for (std::size_t k = 0; k < warm_up + (last - first); ++k) {
      if (k % 4 == 0)
        words = synthesis::random_words(seed, static_cast<std::uint32_t>(chain),
                                        static_cast<std::uint32_t>(chain >> 32),
                                        static_cast<std::uint32_t>(k), chaos_purpose);
      const double draw = total * (words[k % 4] + 0.5) / 4294967296.0;
      const auto map = std::upper_bound(up_to.begin(), up_to.end() - 1, draw) - up_to.begin();
      p = system.maps[static_cast<std::size_t>(map)](p);
      if (k >= warm_up) points[first + k - warm_up] = p;
    }
  });
  return points;
}

AttractorDistance::AttractorDistance(const FunctionSystem& system, double tolerance)
    : maps_(system.maps),
      ball_(attractor_ball(system)),
      point_(fixed_point(system.maps[0])),
      tolerance_(std::max(tolerance, 1e-6 * ball_.radius)) {
  // Here the weight is the stretch: images of images shrink by the product at least.
  for (AffineMap& map : maps_) map.weight = stretch(map.linear);
}

double AttractorDistance::operator()(const glm::dvec3& p, double most) const {
  // Depth first, the nearest image first; what cannot be nearer than the best by more than the tolerance is
  // left out.
  struct Image {
    AffineMap map;
    double nearest;  // no point of it is nearer
  };
  // Kept from point to point: fields ask for millions.
  thread_local std::vector<Image> open;
  open.clear();
  const auto image = [&](const AffineMap& map) {
    return Image{map, glm::distance(map(ball_.centre), p) - map.weight * ball_.radius};
  };
  open.push_back(image({}));
  double best = most;
  int looked_at = 0;
  while (!open.empty()) {
    const Image here = open.back();
    open.pop_back();
    if (here.nearest >= best - tolerance_) continue;
    if (here.map.weight * ball_.radius <= tolerance_ || ++looked_at > most_images) {
      best = std::min(best, glm::distance(here.map(point_), p));
      continue;
    }
    const auto first = static_cast<std::ptrdiff_t>(open.size());
    for (const AffineMap& map : maps_) {
      AffineMap inner = after(here.map, map);
      inner.weight = here.map.weight * map.weight;
      const Image next = image(inner);
      if (next.nearest < best) open.push_back(next);
    }
    std::sort(open.begin() + first, open.end(),
              [](const Image& a, const Image& b) { return a.nearest > b.nearest; });
  }
  return best;
}

}  // namespace verdigris
