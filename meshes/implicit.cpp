#include "implicit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace verdigris::meshes {

Mesh mesh_of_implicit(const std::function<double(glm::dvec3)>& distance, glm::dvec3 lower, glm::dvec3 upper,
                      double cell) {
  std::array<int, 3> count;
  for (int k = 0; k < 3; ++k)
    count[static_cast<std::size_t>(k)] = static_cast<int>(std::ceil((upper[k] - lower[k]) / cell)) + 1;
  const auto [nx, ny, nz] = count;
  const auto at = [&](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(nx) +
           static_cast<std::size_t>(x);
  };
  std::vector<double> values(at(0, 0, nz));
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) values[at(x, y, z)] = distance(lower + cell * glm::dvec3(x, y, z));

  // Where corners of a grid square are in and out by turns, two sheets would share an edge: the one that is
  // out by less comes in.
  for (bool again = true; again;) {
    again = false;
    for (int z = 0; z + 1 < nz; ++z)
      for (int y = 0; y + 1 < ny; ++y)
        for (int x = 0; x + 1 < nx; ++x)
          for (int axis = 0; axis < 3; ++axis) {
            std::array<int, 3> u{}, v{};
            u[static_cast<std::size_t>((axis + 1) % 3)] = 1;
            v[static_cast<std::size_t>((axis + 2) % 3)] = 1;
            double* corner[4];
            for (int k = 0; k < 4; ++k) {
              const int i = k == 1 || k == 2, j = k >= 2;
              corner[k] =
                  &values[at(x + i * u[0] + j * v[0], y + i * u[1] + j * v[1], z + i * u[2] + j * v[2])];
            }
            const bool in = *corner[0] < 0.0;
            if (in == (*corner[1] < 0.0) || in == (*corner[3] < 0.0) || in != (*corner[2] < 0.0)) continue;
            double*& out = in ? (*corner[1] < *corner[3] ? corner[1] : corner[3])
                              : (*corner[0] < *corner[2] ? corner[0] : corner[2]);
            *out = -0.05 * cell;
            again = true;
          }
  }

  // A vertex in each cube that the surface passes, at the mean of where it crosses the cube's edges.
  Mesh mesh;
  std::vector<std::uint32_t> vertex(values.size(), 0);
  for (int z = 0; z + 1 < nz; ++z)
    for (int y = 0; y + 1 < ny; ++y)
      for (int x = 0; x + 1 < nx; ++x) {
        glm::dvec3 sum(0.0);
        int crossings = 0;
        for (int a = 0; a < 8; ++a)
          for (int axis = 0; axis < 3; ++axis) {
            const int b = a | 1 << axis;
            if (b == a) continue;
            const auto corner = [&](int c) { return glm::dvec3(c & 1, c >> 1 & 1, c >> 2 & 1); };
            const double va = values[at(x + (a & 1), y + (a >> 1 & 1), z + (a >> 2 & 1))];
            const double vb = values[at(x + (b & 1), y + (b >> 1 & 1), z + (b >> 2 & 1))];
            if ((va < 0.0) == (vb < 0.0)) continue;
            sum += corner(a) + va / (va - vb) * (corner(b) - corner(a));
            ++crossings;
          }
        if (crossings == 0) continue;
        vertex[at(x, y, z)] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(lower + cell * (glm::dvec3(x, y, z) + sum / static_cast<double>(crossings)));
      }

  // A quad across each edge of the grid that the surface crosses.
  for (int z = 1; z + 1 < nz; ++z)
    for (int y = 1; y + 1 < ny; ++y)
      for (int x = 1; x + 1 < nx; ++x)
        for (int axis = 0; axis < 3; ++axis) {
          std::array<int, 3> p{x, y, z}, q = p, u{}, v{};
          ++q[static_cast<std::size_t>(axis)];
          u[static_cast<std::size_t>((axis + 1) % 3)] = 1;
          v[static_cast<std::size_t>((axis + 2) % 3)] = 1;
          const bool inside = values[at(x, y, z)] < 0.0;
          if (inside == (values[at(q[0], q[1], q[2])] < 0.0)) continue;
          const auto corner = [&](int i, int j) {
            return vertex[at(x - i * u[0] - j * v[0], y - i * u[1] - j * v[1], z - i * u[2] - j * v[2])];
          };
          std::array<std::uint32_t, 4> quad{corner(1, 1), corner(0, 1), corner(0, 0), corner(1, 0)};
          if (!inside) std::swap(quad[1], quad[3]);
          const auto length = [&](std::size_t i, std::size_t j) {
            return glm::distance(mesh.positions[quad[i]], mesh.positions[quad[j]]);
          };
          const std::size_t first = length(0, 2) <= length(1, 3) ? 0 : 1;  // the shorter diagonal
          mesh.triangles.emplace_back(quad[first], quad[first + 1], quad[first + 2]);
          mesh.triangles.emplace_back(quad[first], quad[first + 2], quad[(first + 3) % 4]);
        }
  return mesh;
}

double capsule(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double ra, double rb) {
  const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
  return glm::distance(p, a + t * (b - a)) - (ra + t * (rb - ra));
}

double ellipsoid(glm::dvec3 p, glm::dvec3 centre, glm::dvec3 radii) {
  const double k = glm::length((p - centre) / radii), g = glm::length((p - centre) / (radii * radii));
  return g > 0.0 ? k * (k - 1.0) / g : -std::min({radii.x, radii.y, radii.z});
}

double ring(glm::dvec3 p, glm::dvec3 centre, int axis, double major, double minor) {
  glm::dvec3 d = p - centre;
  const double along = d[axis];
  d[axis] = 0.0;
  return std::hypot(glm::length(d) - major, along) - minor;
}

double join(double a, double b, double blend) {
  const double h = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - 0.25 * h * h * blend;
}

}  // namespace verdigris::meshes
