#pragma once
// The model that benches run on: a sphere of as many triangles as asked for, made in place.

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "verdigris/mesh/mesh.hpp"

namespace bench {

/// Unit sphere of 20 n^2 triangles: an icosahedron with each face cut into n^2 and pushed out.
inline verdigris::Mesh sphere(int n) {
  using verdigris::Mesh;
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  const glm::dvec3 corner[12] = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  const int face[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  Mesh mesh;
  for (const auto& f : face) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    std::uint32_t row = base;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i + j <= n; ++i) {
        // Weights in whole numbers and a fixed order of corners: both faces at an edge get the same bits.
        int w[3] = {n - i - j, i, j}, v[3] = {f[0], f[1], f[2]};
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2 - a; ++b)
            if (v[b] > v[b + 1]) {
              std::swap(v[b], v[b + 1]);
              std::swap(w[b], w[b + 1]);
            }
        glm::dvec3 p(0.0);
        for (int k = 0; k < 3; ++k) p += static_cast<double>(w[k]) * corner[v[k]];
        mesh.positions.push_back(glm::normalize(p));
      }
      const auto wide = static_cast<std::uint32_t>(n - j + 1), above = row + wide;
      for (std::uint32_t i = 0; i + 1 < wide; ++i) {
        mesh.triangles.push_back({row + i, row + i + 1, above + i});
        if (i + 2 < wide) mesh.triangles.push_back({row + i + 1, above + i + 1, above + i});
      }
      row = above;
    }
  }
  return verdigris::weld(mesh);
}

/// Subdivision at which `cells` cells make patches of about `per_patch`.
inline int subdivision(double cells, double per_patch) {
  return std::max(1, static_cast<int>(std::lround(std::sqrt(cells / per_patch / 20.0))));
}

}  // namespace bench
