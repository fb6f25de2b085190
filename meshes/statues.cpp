// Models to weather: an anchor, a bear, a roof.

#include "statues.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "implicit.hpp"
#include "thin_out.hpp"

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
    d = join(d, ellipsoid(p, {0.0, 1.42, 0.0}, {0.10, 0.12, 0.10}), 0.05);  // hub of the stock
    // The stock stands across the arms, with a ball at each end.
    d = join(d, capsule({p.x, p.y, std::abs(p.z)}, {0.0, 1.42, 0.0}, {0.0, 1.42, 0.56}, 0.055, 0.042), 0.04);
    d = join(d, ellipsoid({p.x, p.y, std::abs(p.z)}, {0.0, 1.42, 0.58}, glm::dvec3(0.075)), 0.03);
    d = join(d, ring(p, {0.0, 1.80, 0.0}, 0, 0.15, 0.034), 0.02);
    // Arms along an arc, the same on both sides, thinner outwards.
    const glm::dvec3 q(std::abs(p.x), p.y, p.z);
    const double angle = std::clamp(std::atan2(q.x, 0.88 - q.y), 0.0, 1.2);
    const glm::dvec3 on(0.80 * std::sin(angle), 0.88 - 0.80 * std::cos(angle), 0.0);
    d = join(d, glm::distance(q, on) - (0.095 - 0.045 * angle / 1.2), 0.05);
    // Palms: plates on the inner side of the ends, shaped like a heart; the bills reach beyond them.
    const glm::dvec3 along(std::cos(1.12), std::sin(1.12), 0.0), inwards(-along.y, along.x, 0.0);
    const glm::dvec3 r = q - glm::dvec3(0.80 * std::sin(1.05), 0.88 - 0.80 * std::cos(1.05), 0.0);
    const double u = glm::dot(r, along), v = glm::dot(r, inwards) - 0.045;
    const double half = 0.205 * std::sqrt(std::max(0.0, 1.0 - std::pow((u - 0.02) / 0.24, 2.0))) *
                        (1.0 - 0.55 * std::clamp((u + 0.1) / 0.34, 0.0, 1.0));
    // As of a rounded box; across, the way is shorter where the outline slopes.
    const double dv = std::abs(v) - 0.006, dz = 0.7 * (std::abs(q.z) - half), du = std::abs(u - 0.02) - 0.24;
    const double flat = std::hypot(std::max(dv, 0.0), std::max(dz, 0.0), std::max(du, 0.0)) +
                        std::min(std::max({dv, dz, du}), 0.0);
    d = join(d, flat - 0.022, 0.02);
    const glm::dvec3 end(0.80 * std::sin(1.2), 0.88 - 0.80 * std::cos(1.2), 0.0);
    return join(d, capsule(q, end, end + glm::dvec3(0.05, 0.13, 0.0), 0.05, 0.014), 0.03);
  };
  return thin_out(mesh_of_implicit(distance, {-0.99, -0.11, -0.73}, {0.99, 2.05, 0.73}, 0.0111), 18000);
}

Mesh make_bear() {
  const auto carve = [](double a, double b, double blend) { return -join(-a, b, blend); };
  const auto distance = [&](glm::dvec3 p) {
    const glm::dvec3 q(std::abs(p.x), p.y, p.z);
    double d = ellipsoid(p, {0.0, 2.50, -0.35}, {1.12, 1.15, 1.05});                    // hips
    d = join(d, ellipsoid(p, {0.0, 3.72, -0.05}, {0.88, 1.15, 0.80}), 0.50);            // chest
    d = join(d, ellipsoid(q, {0.45, 4.22, 0.05}, {0.55, 0.58, 0.60}), 0.30);            // shoulders
    d = join(d, capsule(p, {0.0, 4.50, 0.05}, {0.0, 5.20, 0.35}, 0.62, 0.55), 0.35);    // neck
    d = join(d, capsule(q, {0.60, 4.10, 0.35}, {0.68, 2.90, 0.85}, 0.40, 0.29), 0.20);  // forelegs
    d = join(d, capsule(q, {0.68, 2.90, 0.85}, {0.52, 1.75, 1.05}, 0.29, 0.24), 0.08);
    d = join(d, ellipsoid(q, {0.98, 2.15, 0.20}, {0.47, 0.78, 0.82}), 0.16);            // thighs
    d = join(d, capsule(q, {1.06, 1.55, 0.50}, {1.22, 1.48, 1.35}, 0.27, 0.22), 0.10);  // hind feet
    d = join(d, ellipsoid(q, {0.52, 1.50, 1.20}, {0.30, 0.25, 0.42}), 0.10);            // paws
    for (const double toe : {-0.18, 0.0, 0.18}) {
      d = join(d, ellipsoid(q, {0.52 + toe, 1.40, 1.56}, {0.11, 0.14, 0.15}), 0.05);
      d = join(d, ellipsoid(q, {1.25 + 0.85 * toe, 1.39, 1.54}, {0.10, 0.13, 0.15}), 0.05);
    }
    d = join(d, ellipsoid(p, {0.0, 5.62, 0.55}, {0.80, 0.70, 0.72}), 0.22);             // head
    d = join(d, ellipsoid(q, {0.44, 5.36, 0.74}, {0.40, 0.36, 0.38}), 0.18);            // cheeks
    d = join(d, capsule(p, {0.0, 5.44, 1.05}, {0.0, 5.32, 1.58}, 0.38, 0.25), 0.14);    // snout
    d = join(d, ellipsoid(p, {0.0, 5.08, 1.32}, {0.24, 0.15, 0.34}), 0.05);             // jaw
    d = join(d, capsule(q, {0.15, 5.90, 1.12}, {0.48, 5.84, 0.98}, 0.10, 0.09), 0.10);  // brows
    d = join(d, ellipsoid(q, {0.62, 6.20, 0.35}, {0.29, 0.30, 0.16}), 0.08);            // ears
    d = carve(d, ellipsoid(q, {0.63, 6.24, 0.52}, {0.17, 0.19, 0.13}), 0.05);
    d = carve(d, capsule(q, {0.0, 5.13, 1.85}, {0.30, 5.19, 1.30}, 0.05, 0.04), 0.04);  // mouth
    d = carve(d, ellipsoid(q, {0.31, 5.70, 1.22}, {0.16, 0.11, 0.12}), 0.05);           // eyes
    d = join(d, ellipsoid(q, {0.31, 5.69, 1.16}, {0.10, 0.085, 0.085}), 0.01);
    // Locks of fur, as a sculptor models them; none on the face and the paws.
    const double fur = std::clamp((q.y - 1.75) / 0.3, 0.0, 1.0) *
                       std::clamp(2.0 * (glm::distance(p, {0.0, 5.40, 1.45}) - 0.75), 0.0, 1.0);
    const double sway = 0.9 * std::sin(1.9 * p.y + 2.0 * p.z) + 0.7 * std::sin(2.3 * p.x - 1.3 * p.y);
    d += 0.034 * fur * std::sin(9.5 * p.x + 2.1 * sway) * std::sin(9.5 * p.z - 1.7 * sway + 0.7) +
         0.022 * fur * std::sin(4.6 * p.y + 3.0 * sway + 6.0 * std::abs(p.x));
    d = join(d, ellipsoid(p, {0.0, 5.47, 1.80}, {0.18, 0.13, 0.12}), 0.05);  // nose
    // A plinth with a ledge.
    d = join(d, box(p, {0.0, 1.20, 0.15}, {1.66, 0.12, 1.66}, 0.05), 0.05);
    d = join(d, box(p, {0.0, 0.75, 0.15}, {1.48, 0.45, 1.48}, 0.04), 0.07);
    return join(d, box(p, {0.0, 0.26, 0.15}, {1.66, 0.16, 1.66}, 0.05), 0.07);
  };
  return thin_out(mesh_of_implicit(distance, {-1.95, 0.012, -1.807}, {1.95, 6.75, 2.10}, 0.0461), 30000);
}

Mesh make_roof() {
  // What stands on the eastern slope, between two seams each: from x0, z0 to x1, z1, up to a height or, below
  // zero, by so much off the slope.
  struct Box {
    double x0, x1, z0, z1, top;
  };
  constexpr std::array<Box, 3> boxes{
      {{0.85, 1.40, 0.98, 1.40, 3.35}, {1.10, 1.85, -1.47, -0.90, -0.20}, {0.55, 0.72, -2.86, -2.69, -0.55}}};
  constexpr double half_width = 2.4, half_length = 3.2, eave = 1.0, ridge = 2.9, seam = 0.05;
  constexpr double edge = 0.02, fold = 0.012, cap = 0.15, cap_height = 0.07;
  // Lines of the grid: along the slope with the sides of boxes, along the ridge with each seam's four.
  std::vector<double> xs{-half_width, -cap - 0.01, -cap, -edge, edge, cap, cap + 0.01, half_width};
  std::vector<std::pair<double, bool>> zs;  // and whether a seam is there
  for (int k = 0; k < 9; ++k) {
    const double z = -half_length + 0.04 + (2.0 * half_length - 0.08) * k / 8.0;
    for (const double d : {-0.03, -0.03 + fold, 0.03 - fold, 0.03})
      zs.emplace_back(z + d, std::abs(d) < 0.025);
  }
  for (const Box& box : boxes) {
    for (const double x : {box.x0 - edge, box.x0, box.x1, box.x1 + edge}) xs.push_back(x);
    for (const double z : {box.z0 - edge, box.z0, box.z1, box.z1 + edge}) zs.emplace_back(z, false);
  }
  std::sort(xs.begin(), xs.end());
  std::sort(zs.begin(), zs.end());
  const auto n = static_cast<std::uint32_t>(xs.size()), m = static_cast<std::uint32_t>(zs.size());
  Mesh mesh;
  const auto pitched = [&](double x) { return eave + (ridge - eave) * (1.0 - std::abs(x) / half_width); };
  for (const bool lower : {false, true})
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        const double x = xs[i], z = zs[j].first, slope = pitched(x);
        double y = slope + std::max(zs[j].second ? seam : 0.0, std::abs(x) <= cap ? cap_height : 0.0);
        for (const Box& box : boxes)
          if (x >= box.x0 && x <= box.x1 && z >= box.z0 && z <= box.z1)
            y = box.top < 0.0 ? slope - box.top : box.top;
        if (lower) y = slope - 0.12;
        mesh.positions.emplace_back(x, y, z);
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
