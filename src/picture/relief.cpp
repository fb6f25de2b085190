// Source: Gobron & Chiba 1999, "Structure problem: edge thickness correspondence", Fig. 20.
#include "verdigris/picture/relief.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

Relief ReliefMaker::operator()(std::vector<float> heights) const {
  const Surface& surface = blends_.surface();
  Relief relief{std::move(heights), std::vector<glm::vec3>(surface.slot_count(), glm::vec3(0.0f))};
  ghosts_.fill(relief.heights);
  const auto& h = relief.heights;
  // Of one line of three: central where both sides are known, else towards the one that is.
  const auto slope = [&](std::uint32_t before, std::uint32_t here, std::uint32_t after) {
    const bool has_before = blends_.has_value(before), has_after = blends_.has_value(after);
    const float span = static_cast<float>(has_before) + static_cast<float>(has_after);
    return span > 0.0f ? (h[has_after ? after : here] - h[has_before ? before : here]) / span : 0.0f;
  };
  const auto find_slopes = [&] {
    const auto scale = static_cast<float>(1.0 / surface.cell_size());
    tbb::parallel_for(
        tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(surface.rows().size()), 256),
        [&](const tbb::blocked_range<std::uint32_t>& range) {
          for (std::uint32_t row = range.begin(); row < range.end(); ++row) {
            const SlotRun run = surface.owned(row);
            if (run.begin == run.end) continue;
            const Frame& frame = surface.frame(surface.patch_of_row(row));
            const glm::vec3 u = scale * glm::vec3(frame.u), v = scale * glm::vec3(frame.v);
            const Row &here = surface.rows()[row], &above = surface.rows()[row + 1],
                      &below = surface.rows()[row - 1];
            for (std::uint32_t s = run.begin; s < run.end; ++s) {
              const std::uint32_t column = s - here.base;
              relief.slopes[s] =
                  slope(s - 1, s, s + 1) * u + slope(below.base + column, s, above.base + column) * v;
            }
          }
        });
    copy_to_ghosts(surface, relief.slopes);
  };
  find_slopes();
  ghosts_.fill(relief.heights, relief.slopes);
  find_slopes();
  return relief;
}

std::vector<glm::vec3> relief_directions(const Mesh& mesh) {
  const auto visit = [&](auto&& each) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const glm::dvec3 area =
          glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
      const double length = glm::length(area);
      if (!(length > 0.0)) continue;
      for (int k = 0; k < 3; ++k) {
        const glm::dvec3 a = mesh.corner(t, (k + 1) % 3) - mesh.corner(t, k);
        const glm::dvec3 b = mesh.corner(t, (k + 2) % 3) - mesh.corner(t, k);
        each(mesh.triangles[t][k], std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)), area / length);
      }
    }
  };
  std::vector<glm::dvec3> means(mesh.positions.size(), glm::dvec3(0.0));
  visit([&](std::uint32_t vertex, double angle, glm::dvec3 normal) { means[vertex] += angle * normal; });
  for (glm::dvec3& mean : means) mean = glm::length(mean) > 1e-9 ? glm::normalize(mean) : glm::dvec3(0.0);
  std::vector<glm::dvec2> advance(means.size(), glm::dvec2(0.0));  // sum of weights, sum of normal parts
  visit([&](std::uint32_t vertex, double angle, glm::dvec3 normal) {
    advance[vertex] += glm::dvec2(angle, angle * glm::dot(normal, means[vertex]));
  });
  std::vector<glm::vec3> directions(means.size());
  for (std::size_t v = 0; v < means.size(); ++v)
    directions[v] = glm::vec3(means[v] / std::max(0.5, advance[v].y / std::max(advance[v].x, 1e-30)));
  return directions;
}

void relieve_bands(const BandMesh& bands, const Relief& relief, std::span<glm::vec3> positions,
                   std::span<PackedNormal> normals) {
  const auto move = [&](std::uint32_t vertex, float height, glm::vec3 slope) {
    positions[vertex] = bands.positions[vertex] + height * bands.directions[vertex];
    if (slope == glm::vec3(0.0f)) {
      normals[vertex] = bands.normals[vertex];
      return;
    }
    const glm::vec3 n = unpack_normal(bands.normals[vertex]);
    normals[vertex] = pack_normal(glm::normalize(n - (slope - glm::dot(slope, n) * n)));
  };
  for (const CentreRun& run : bands.centres)
    for (std::uint32_t k = 0; k < run.count; ++k)
      move(run.vertex + k, relief.heights[run.slot + k], relief.slopes[run.slot + k]);
  for (const ContourRun& run : bands.contours)
    for (std::uint32_t k = 0; k < run.count; ++k) {
      float height = 0.0f;
      glm::vec3 slope(0.0f);
      for (std::uint32_t n = bands.blend_begin[run.blend + k]; n < bands.blend_begin[run.blend + k + 1];
           ++n) {
        const BlendSource& from = bands.blends[n];
        height += from.weight * relief.heights[from.slot];
        slope += from.weight * relief.slopes[from.slot];
      }
      move(run.vertex + k, height, slope);
    }
}

void drop_holes(std::vector<std::uint32_t>& triangles, std::span<const std::uint8_t> present) {
  const auto gone = [&](std::uint32_t vertex) { return present[vertex] < 128; };
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    if (gone(triangles[t]) && gone(triangles[t + 1]) && gone(triangles[t + 2])) continue;
    std::copy_n(triangles.begin() + static_cast<std::ptrdiff_t>(t), 3,
                triangles.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += 3;
  }
  triangles.resize(kept);
}

}  // namespace verdigris
