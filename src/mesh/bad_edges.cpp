#include "bad_edges.hpp"

#include <tuple>

namespace verdigris {

std::vector<BadSide> bad_sides(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<BadSide> bad;
  for (std::uint32_t h = 0; h < adjacency.kind.size(); ++h) {
    if (adjacency.kind[h] != EdgeKind::non_manifold && adjacency.kind[h] != EdgeKind::inconsistent) continue;
    const glm::uvec3& t = mesh.triangles[h / 3];
    const std::uint32_t a = t[static_cast<int>(h % 3)], b = t[static_cast<int>((h % 3 + 1) % 3)];
    bad.push_back({std::min(a, b), std::max(a, b), h});
  }
  std::sort(bad.begin(), bad.end(), [](const BadSide& x, const BadSide& y) {
    return std::tie(x.lower, x.upper, x.half_edge) < std::tie(y.lower, y.upper, y.half_edge);
  });
  return bad;
}

std::vector<std::uint32_t> two_sided_links(const Adjacency& adjacency, const std::vector<BadSide>& bad) {
  std::vector<std::uint32_t> links = adjacency.opposite;
  for_each_bad_edge(bad, [&links](auto first, auto last) {
    if (last - first != 2) return;
    links[first->half_edge] = first[1].half_edge;
    links[first[1].half_edge] = first->half_edge;
  });
  return links;
}

}  // namespace verdigris
