#include "ear_clip.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace verdigris::io {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Twice the signed area: above 0 when a, b, c turn left.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The polygon's normal, about twice its area long (Newell's method; M. Newell in Sutherland, Sproull &
/// Schumacker 1974).
glm::dvec3 newell_normal(std::span<const glm::dvec3> p) {
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < p.size(); ++i) {
    // Relative to the first corner, or a polygon far from the origin would lose its digits.
    const glm::dvec3 a = p[i] - p[0], b = p[(i + 1) % p.size()] - p[0];
    normal += glm::cross(a, b);
  }
  return normal;
}

/// A ring of corners in their plane, from which ears are cut until three are left.
class EarClipper {
 public:
  explicit EarClipper(std::span<const glm::dvec3> corners) {
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (ids_.empty() || corners[i] != corners[ids_.back()]) ids_.push_back(static_cast<std::uint32_t>(i));
    while (ids_.size() > 1 && corners[ids_.back()] == corners[ids_.front()]) ids_.pop_back();
    std::vector<glm::dvec3> kept;
    for (const std::uint32_t i : ids_) kept.push_back(corners[i]);
    if (ids_.size() > 2) flatten(kept);
  }

  std::size_t size() const { return ids_.size(); }

  void cut(std::vector<std::array<std::uint32_t, 3>>& out) {
    const std::size_t n = ids_.size();
    next_.resize(n);
    previous_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[i] = (i + n - 1) % n;
    }
    cost_.resize(n);
    gone_.assign(n, false);
    for (std::size_t i = 0; i < n; ++i)
      if (turn(flat_[previous_[i]], flat_[i], flat_[next_[i]]) <= slack_) bent_in_.push_back(i);
    find_ears();

    std::size_t start = 0;
    for (std::size_t left = n; left > 3; --left) {
      std::size_t best = cheapest(start);
      // A polygon thinner than its rounding: what is left has to do.
      if (cost_[best] == never && slack_ > 0.0) {
        slack_ = 0.0;
        find_ears();
        best = cheapest(start);
      }
      if (cost_[best] == never) best = widest(start);
      const std::size_t before = previous_[best], after = next_[best];
      emit(before, best, after, out);
      next_[before] = after;
      previous_[after] = before;
      gone_[best] = true;
      cost_[before] = cost(before);
      cost_[after] = cost(after);
      if (best == start) start = after;
    }
    emit(previous_[start], start, next_[start], out);
  }

 private:
  void flatten(std::span<const glm::dvec3> p) {
    const glm::dvec3 normal = newell_normal(p);
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int u = (drop + 1) % 3, v = (drop + 2) % 3;
    const double side = normal[drop] < 0.0 ? -1.0 : 1.0;
    for (const glm::dvec3& q : p) flat_.push_back({q[u] - p[0][u], side * (q[v] - p[0][v])});
    solid_.assign(p.begin(), p.end());
    double extent = 0.0, reach = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      extent = std::max({extent, std::abs(flat_[i].x), std::abs(flat_[i].y)});
      reach = std::max({reach, std::abs(p[i].x), std::abs(p[i].y), std::abs(p[i].z)});
    }
    slack_ =
        1e-14 * extent * (extent + reach);  // rounding of the positions, some fifty units in the last place
  }

  void find_ears() {
    for (std::size_t i = 0; i < cost_.size(); ++i)
      if (!gone_[i]) cost_[i] = cost(i);
  }

  std::size_t cheapest(std::size_t start) const {
    std::size_t best = start;
    for (std::size_t i = next_[start]; i != start; i = next_[i])
      if (cost_[i] < cost_[best]) best = i;
    return best;
  }

  void emit(std::size_t a, std::size_t b, std::size_t c,
            std::vector<std::array<std::uint32_t, 3>>& out) const {
    out.push_back({ids_[a], ids_[b], ids_[c]});
  }

  /// Squared length of the diagonal that cutting corner `i` off would make, or `never` when `i` is no ear.
  double cost(std::size_t i) const {
    const std::size_t before = previous_[i], after = next_[i];
    const glm::dvec2 &a = flat_[before], &b = flat_[i], &c = flat_[after];
    if (!(turn(a, b, c) > slack_)) return never;
    for (const std::size_t r : bent_in_) {  // only a corner that bends in can be first inside an ear
      if (gone_[r] || r == i || r == before || r == after) continue;
      const glm::dvec2& p = flat_[r];
      if (p == a || p == b || p == c) continue;  // a hole's bridge touches the outline
      // On the border counts as inside: cutting there would leave a sliver of no area.
      if (turn(a, b, p) >= -slack_ && turn(b, c, p) >= -slack_ && turn(c, a, p) >= -slack_) return never;
    }
    const glm::dvec3 diagonal = solid_[after] - solid_[before];
    return glm::dot(diagonal, diagonal);
  }

  /// Of a ring without ears (it crosses itself, or lies on a line) the corner that loses least.
  std::size_t widest(std::size_t start) const {
    std::size_t best = start;
    double most = -never;
    std::size_t i = start;
    do {
      const double area = turn(flat_[previous_[i]], flat_[i], flat_[next_[i]]);
      if (area > most) {
        most = area;
        best = i;
      }
      i = next_[i];
    } while (i != start);
    return best;
  }

  std::vector<std::uint32_t> ids_;  // [kept corner] -> corner given
  std::vector<glm::dvec2> flat_;    // [kept corner] in the plane, counter-clockwise
  std::vector<glm::dvec3> solid_;
  std::vector<std::size_t> next_, previous_, bent_in_;
  std::vector<double> cost_;
  std::vector<bool> gone_;
  double slack_ = 0.0;  // turns below this are straight
};

}  // namespace

void triangulate_polygon(std::span<const glm::dvec3> corners,
                         std::vector<std::array<std::uint32_t, 3>>& out) {
  EarClipper clipper(corners);
  if (clipper.size() < 3)
    out.push_back({0, 1, 2});
  else
    clipper.cut(out);
}

}  // namespace verdigris::io
