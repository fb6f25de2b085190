// Models to weather: an anchor, a bust, a roof.

#include "statues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "implicit.hpp"

namespace verdigris::meshes {

namespace {

double box(glm::dvec3 p, glm::dvec3 centre, glm::dvec3 half, double rounding) {
  double outside = 0.0, inside = -1e30;
  for (int k = 0; k < 3; ++k) {
    const double d = std::abs(p[k] - centre[k]) - half[k] + rounding;
    outside += std::max(d, 0.0) * std::max(d, 0.0);
    inside = std::max(inside, d);
  }
  return std::sqrt(outside) + std::min(inside, 0.0) - rounding;
}

}  // namespace

Mesh make_anchor() {
  const auto distance = [](glm::dvec3 p) {
    double d = capsule(p, {0.0, 0.12, 0.0}, {0.0, 1.62, 0.0}, 0.085, 0.06);
    // The stock stands across the arms, with a ball at each end.
    d = join(d, capsule({p.x, p.y, std::abs(p.z)}, {0.0, 1.42, 0.0}, {0.0, 1.42, 0.56}, 0.055, 0.042), 0.04);
    d = join(d, ellipsoid({p.x, p.y, std::abs(p.z)}, {0.0, 1.42, 0.58}, glm::dvec3(0.072)), 0.03);
    d = join(d, ring(p, {0.0, 1.80, 0.0}, 0, 0.15, 0.034), 0.02);
    // Arms in four straight pieces along an arc, the same on both sides.
    const glm::dvec3 q(std::abs(p.x), p.y, p.z);
    glm::dvec3 from(0.0, 0.08, 0.0);
    for (int k = 1; k <= 6; ++k) {
      const double angle = k * 0.205;
      const glm::dvec3 to(0.80 * std::sin(angle), 0.88 - 0.80 * std::cos(angle), 0.0);
      d = join(d, capsule(q, from, to, 0.095 - 0.008 * (k - 1), 0.095 - 0.008 * k), 0.03);
      from = to;
    }
    // Flukes: flat plates across the ends, and the bills beyond them.
    const glm::dvec3 r(0.8 * (q.x - 0.70) + 0.6 * (q.y - 0.56), -0.6 * (q.x - 0.70) + 0.8 * (q.y - 0.56),
                       q.z);
    d = join(d, ellipsoid(r, {0.02, 0.045, 0.0}, {0.20, 0.045, 0.19}), 0.04);
    return join(d, capsule(q, from, from + glm::dvec3(0.05, 0.12, 0.0), 0.05, 0.018), 0.03);
  };
  return mesh_of_implicit(distance, {-0.99, -0.11, -0.73}, {0.99, 2.05, 0.73}, 0.0275);
}

Mesh make_bust() {
  const auto distance = [](glm::dvec3 p) {
    const glm::dvec3 q(std::abs(p.x), p.y, p.z);
    double d = ellipsoid(p, {0.0, 5.55, 0.10}, {0.82, 1.08, 0.98});                      // head
    d = join(d, ellipsoid(p, {0.0, 4.78, 0.36}, {0.52, 0.52, 0.56}), 0.35);              // jaw
    d = join(d, capsule(p, {0.0, 5.62, 1.02}, {0.0, 5.20, 1.22}, 0.07, 0.13), 0.14);     // nose
    d = join(d, capsule(q, {0.12, 5.78, 1.00}, {0.52, 5.80, 0.78}, 0.10, 0.08), 0.12);   // brows
    d = join(d, ellipsoid(q, {0.33, 5.56, 0.86}, {0.17, 0.11, 0.14}), 0.06);             // eyes
    d = join(d, ellipsoid(p, {0.0, 4.90, 0.95}, {0.24, 0.08, 0.12}), 0.10);              // lips
    d = join(d, ellipsoid(p, {0.0, 4.52, 0.74}, {0.20, 0.17, 0.18}), 0.16);              // chin
    d = join(d, ellipsoid(q, {0.84, 5.40, 0.05}, {0.11, 0.28, 0.18}), 0.06);             // ears
    d = join(d, ellipsoid(p, {0.0, 5.86, -0.12}, {0.90, 0.92, 0.98}), 0.12);             // hair
    d = join(d, ellipsoid(p, {0.0, 5.80, -1.12}, {0.44, 0.44, 0.40}), 0.12);             // bun
    d = join(d, capsule(p, {0.0, 4.75, -0.10}, {0.0, 3.70, -0.18}, 0.42, 0.52), 0.40);   // neck
    d = join(d, capsule(q, {0.0, 3.42, -0.20}, {1.42, 3.02, -0.18}, 0.52, 0.50), 0.55);  // shoulders
    d = join(d, ellipsoid(p, {0.0, 2.60, 0.02}, {1.32, 1.10, 0.78}), 0.50);              // chest
    d = std::max(d, 1.62 - p.y);                                                         // cut below
    d = join(d, capsule(p, {0.0, 1.75, 0.0}, {0.0, 1.15, 0.0}, 0.52, 0.42), 0.25);       // foot
    d = join(d, box(p, {0.0, 0.98, 0.0}, {0.98, 0.14, 0.98}, 0.04), 0.06);               // ledges
    d = join(d, box(p, {0.0, 0.50, 0.0}, {0.78, 0.50, 0.78}, 0.04), 0.06);
    return join(d, box(p, {0.0, 0.02, 0.0}, {1.10, 0.22, 1.10}, 0.05), 0.06);
  };
  return mesh_of_implicit(distance, {-2.33, -0.37, -1.87}, {2.33, 7.11, 1.87}, 0.0989);
}

Mesh make_roof() {
  // Lines of the grid: along the slope with the chimney's sides, along the ridge with each seam's four.
  constexpr double half_width = 2.4, half_length = 3.2, eave = 1.0, ridge = 2.9, seam = 0.045;
  constexpr double top = 3.25, edge = 0.04, fold = 0.012;
  std::vector<double> xs{-half_width, -edge, edge};
  for (const double x : {0.9 - edge, 0.9, 1.5, 1.5 + edge, half_width}) xs.push_back(x);
  std::vector<double> zs;
  std::vector<bool> raised;
  const auto add = [&](double z, bool up) { zs.push_back(z), raised.push_back(up); };
  for (int k = 0; k < 9; ++k) {
    const double z = -half_length + 0.04 + (2.0 * half_length - 0.08) * k / 8.0;
    add(z - 0.03, false), add(z - 0.03 + fold, true), add(z + 0.03 - fold, true), add(z + 0.03, false);
  }
  constexpr std::array<double, 4> chimney{0.95 - edge, 0.95, 1.45, 1.45 + edge};
  for (std::size_t k = 0; k < chimney.size(); ++k) {
    const auto place =
        static_cast<std::size_t>(std::lower_bound(zs.begin(), zs.end(), chimney[k]) - zs.begin());
    zs.insert(zs.begin() + static_cast<std::ptrdiff_t>(place), chimney[k]);
    raised.insert(raised.begin() + static_cast<std::ptrdiff_t>(place), false);
  }
  const auto n = static_cast<std::uint32_t>(xs.size()), m = static_cast<std::uint32_t>(zs.size());
  Mesh mesh;
  const auto pitched = [&](double x) { return eave + (ridge - eave) * (1.0 - std::abs(x) / half_width); };
  for (const bool lower : {false, true})
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        double y = pitched(xs[i]) + (raised[j] ? seam : 0.0);
        if (xs[i] >= 0.9 && xs[i] <= 1.5 && zs[j] >= 0.95 && zs[j] <= 1.45) y = top;
        if (lower) y = pitched(xs[i]) - 0.12;
        mesh.positions.emplace_back(xs[i], y, zs[j]);
      }
  const auto at = [&](std::uint32_t i, std::uint32_t j, bool lower) {
    return (lower ? n * m : 0u) + j * n + i;
  };
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.emplace_back(a, b, c);
    mesh.triangles.emplace_back(a, c, d);
  };
  for (std::uint32_t j = 0; j + 1 < m; ++j)
    for (std::uint32_t i = 0; i + 1 < n; ++i) {
      quad(at(i, j, false), at(i, j + 1, false), at(i + 1, j + 1, false), at(i + 1, j, false));
      quad(at(i, j, true), at(i + 1, j, true), at(i + 1, j + 1, true), at(i, j + 1, true));
    }
  for (std::uint32_t j = 0; j + 1 < m; ++j) {
    quad(at(0, j, true), at(0, j + 1, true), at(0, j + 1, false), at(0, j, false));
    quad(at(n - 1, j, false), at(n - 1, j + 1, false), at(n - 1, j + 1, true), at(n - 1, j, true));
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    quad(at(i, 0, false), at(i + 1, 0, false), at(i + 1, 0, true), at(i, 0, true));
    quad(at(i, m - 1, true), at(i + 1, m - 1, true), at(i + 1, m - 1, false), at(i, m - 1, false));
  }
  return mesh;
}

}  // namespace verdigris::meshes
