#include "verdigris/mesh/adjacency.hpp"

#include <algorithm>

namespace verdigris {

namespace {

/// The two ends of a half-edge, in its own direction.
struct Ends {
  std::uint32_t from, to;
};

Ends ends_of(const Mesh& mesh, std::size_t half_edge) {
  const glm::uvec3& t = mesh.triangles[half_edge / 3];
  const auto k = static_cast<int>(half_edge % 3);
  return {t[k], t[(k + 1) % 3]};
}

}  // namespace

// Half-edges are put into buckets by their lower vertex (a counting sort), and within a bucket chained by
// their upper vertex through one scratch array. Nothing is compared, so a hub vertex of a million triangles
// costs no more than a regular one.
Adjacency make_adjacency(const Mesh& mesh) {
  const std::size_t half_edges = 3 * mesh.triangles.size();
  const std::size_t vertices = mesh.positions.size();
  Adjacency adjacency;
  adjacency.opposite.assign(half_edges, Adjacency::none);
  adjacency.kind.assign(half_edges, EdgeKind::boundary);

  std::vector<std::uint32_t> bucket(vertices + 1, 0);  // [lower vertex] -> its first entry
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++bucket[std::min(t[k], t[(k + 1) % 3]) + 1];
  for (std::size_t v = 0; v < vertices; ++v) bucket[v + 1] += bucket[v];

  struct Entry {
    std::uint32_t half_edge, upper;
  };
  std::vector<Entry> entries(half_edges);
  std::vector<std::uint32_t> fill(bucket.begin(), bucket.end() - 1);
  for (std::size_t h = 0; h < half_edges; ++h) {
    const auto [from, to] = ends_of(mesh, h);
    entries[fill[std::min(from, to)]++] = {static_cast<std::uint32_t>(h), std::max(from, to)};
  }

  std::vector<std::uint32_t> last(vertices, Adjacency::none);        // [upper vertex] -> last half-edge seen
  std::vector<std::uint32_t> previous(half_edges, Adjacency::none);  // chain of half-edges on one edge
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::uint32_t e = bucket[v]; e < bucket[v + 1]; ++e) {
      const auto [h, upper] = entries[e];
      previous[h] = last[upper];
      last[upper] = h;
    }
    for (std::uint32_t e = bucket[v]; e < bucket[v + 1]; ++e) {
      const std::uint32_t upper = entries[e].upper;
      const std::uint32_t h = last[upper];
      if (h == Adjacency::none) continue;  // this edge is done
      last[upper] = Adjacency::none;
      const std::uint32_t g = previous[h];
      if (g == Adjacency::none) continue;  // one triangle: boundary, as assigned
      if (previous[g] != Adjacency::none) {
        for (std::uint32_t i = h; i != Adjacency::none; i = previous[i])
          adjacency.kind[i] = EdgeKind::non_manifold;
      } else if (ends_of(mesh, h).from == ends_of(mesh, g).from) {
        adjacency.kind[h] = adjacency.kind[g] = EdgeKind::inconsistent;
      } else {
        adjacency.kind[h] = adjacency.kind[g] = EdgeKind::linked;
        adjacency.opposite[h] = g;
        adjacency.opposite[g] = h;
      }
    }
  }
  return adjacency;
}

}  // namespace verdigris
