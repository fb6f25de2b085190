#include "verdigris/mesh/report.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "bad_edges.hpp"
#include "disjoint_sets.hpp"
#include "triangle_set.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t none = Adjacency::none;
constexpr double flat = 1e-12;  // height over longest edge: what rounding leaves of three points on a line

std::uint32_t next_in_triangle(std::uint32_t h) {
  return h % 3 == 2 ? h - 2 : h + 1;
}
std::uint32_t previous_in_triangle(std::uint32_t h) {
  return h % 3 == 0 ? h + 2 : h - 1;
}
std::uint32_t start_of(const Mesh& mesh, std::uint32_t h) {
  return mesh.triangles[h / 3][static_cast<int>(h % 3)];
}

/// Longest edge of a triangle, and its height over that.
struct Shape {
  double longest, height;
};

Shape shape_of(const Mesh& mesh, std::size_t t) {
  const glm::dvec3 a = mesh.corner(t, 1) - mesh.corner(t, 0), b = mesh.corner(t, 2) - mesh.corner(t, 1);
  const glm::dvec3 c = mesh.corner(t, 0) - mesh.corner(t, 2);
  const double longest = std::max({glm::length(a), glm::length(b), glm::length(c)});
  // Of the two edges beside the longest, or rounding of the long ones hides a small height.
  const glm::dvec3 area = glm::length(a) == longest
                              ? glm::cross(b, c)
                              : (glm::length(b) == longest ? glm::cross(c, a) : glm::cross(a, b));
  return {longest, longest > 0.0 ? glm::length(area) / longest : 0.0};
}

std::size_t count_components(std::size_t triangles, const std::vector<std::uint32_t>& links,
                             const std::vector<BadSide>& bad) {
  DisjointSets sets(triangles);
  for (std::uint32_t h = 0; h < links.size(); ++h)
    if (links[h] != none) sets.join(h / 3, links[h] / 3);
  for_each_bad_edge(bad, [&sets](auto first, auto last) {
    for (auto side = first; side != last; ++side) sets.join(first->half_edge / 3, side->half_edge / 3);
  });
  std::size_t components = 0;
  for (std::uint32_t t = 0; t < triangles; ++t) components += sets.find(t) == t;
  return components;
}

/// The boundary edge that follows `edge` round the end of it that is at `vertex`, turning through the fan of
/// triangles between them whichever way these run; none when the fan ends at a non-manifold edge.
std::uint32_t follow_boundary(const Mesh& mesh, const Adjacency& adjacency,
                              const std::vector<std::uint32_t>& links, std::uint32_t edge,
                              std::uint32_t vertex) {
  for (std::uint32_t h = edge;;) {
    const std::uint32_t next = next_in_triangle(h);
    const bool next_touches =
        start_of(mesh, next) == vertex || start_of(mesh, next_in_triangle(next)) == vertex;
    h = next_touches ? next : previous_in_triangle(h);
    if (adjacency.kind[h] == EdgeKind::boundary) return h;
    if (links[h] == none) return none;
    h = links[h];
  }
}

std::size_t count_boundary_loops(const Mesh& mesh, const Adjacency& adjacency,
                                 const std::vector<std::uint32_t>& links) {
  std::vector<std::uint32_t> rank(adjacency.kind.size(), none), boundary;
  for (std::uint32_t h = 0; h < adjacency.kind.size(); ++h)
    if (adjacency.kind[h] == EdgeKind::boundary) {
      rank[h] = static_cast<std::uint32_t>(boundary.size());
      boundary.push_back(h);
    }
  DisjointSets chains(boundary.size());
  std::vector<bool> open(boundary.size(), false);
  for (const std::uint32_t h : boundary)
    for (const std::uint32_t vertex : {start_of(mesh, h), start_of(mesh, next_in_triangle(h))}) {
      const std::uint32_t next = follow_boundary(mesh, adjacency, links, h, vertex);
      if (next == none)
        open[rank[h]] = true;
      else
        chains.join(rank[h], rank[next]);
    }
  for (std::uint32_t i = 0; i < boundary.size(); ++i)
    if (open[i]) open[chains.find(i)] = true;
  std::size_t loops = 0;
  for (std::uint32_t i = 0; i < boundary.size(); ++i) loops += chains.find(i) == i && !open[i];
  return loops;
}

/// Walks once round every fan of linked triangles; a vertex with a second fan is counted once.
std::size_t count_non_manifold_vertices(const Mesh& mesh, const Adjacency& adjacency) {
  std::vector<bool> seen(adjacency.opposite.size(),
                         false);  // [corner], which has the number of the half-edge from it
  std::vector<std::uint8_t> fans(mesh.positions.size(), 0);
  for (std::uint32_t corner = 0; corner < seen.size(); ++corner) {
    if (seen[corner]) continue;
    std::uint8_t& count = fans[start_of(mesh, corner)];
    count = std::min<std::uint8_t>(static_cast<std::uint8_t>(count + 1), 2);
    std::uint32_t h = corner;
    do {
      seen[h] = true;
      h = adjacency.opposite[previous_in_triangle(h)];
    } while (h != none && h != corner);
    if (h == corner) continue;
    for (h = adjacency.opposite[corner]; h != none; h = adjacency.opposite[h]) {
      h = next_in_triangle(h);
      seen[h] = true;
    }
  }
  return static_cast<std::size_t>(std::count(fans.begin(), fans.end(), 2));
}

void measure_edges(const Mesh& mesh, const Adjacency& adjacency, const std::vector<BadSide>& bad,
                   MeshReport& report) {
  double sum = 0.0;
  report.shortest_edge = std::numeric_limits<double>::infinity();
  auto measure = [&](std::uint32_t h) {
    const double length =
        glm::distance(mesh.positions[start_of(mesh, h)], mesh.positions[start_of(mesh, next_in_triangle(h))]);
    ++report.edges;
    sum += length;
    report.shortest_edge = std::min(report.shortest_edge, length);
    report.longest_edge = std::max(report.longest_edge, length);
  };
  for (std::uint32_t h = 0; h < adjacency.kind.size(); ++h) {
    if (adjacency.kind[h] == EdgeKind::boundary) ++report.boundary_edges;
    if (adjacency.kind[h] == EdgeKind::boundary ||
        (adjacency.opposite[h] != none && h < adjacency.opposite[h]))
      measure(h);
  }
  for_each_bad_edge(bad, [&](auto first, auto) {
    const bool two = adjacency.kind[first->half_edge] == EdgeKind::inconsistent;
    ++(two ? report.inconsistent_edges : report.non_manifold_edges);
    measure(first->half_edge);
  });
  if (report.edges == 0) report.shortest_edge = 0.0;
  report.mean_edge = report.edges == 0 ? 0.0 : sum / static_cast<double>(report.edges);
}

}  // namespace

MeshReport inspect(const Mesh& mesh, const Adjacency& adjacency) {
  MeshReport report;
  report.vertices = mesh.positions.size();
  report.triangles = mesh.triangles.size();
  report.area = mesh_area(mesh);
  report.bounds = mesh_bounds(mesh);

  std::vector<bool> used(mesh.positions.size(), false);
  report.smallest_height = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int k = 0; k < 3; ++k) used[mesh.triangles[t][k]] = true;
    const Shape shape = shape_of(mesh, t);
    if (shape.height <= flat * shape.longest)
      ++report.degenerate_triangles;
    else
      report.smallest_height = std::min(report.smallest_height, shape.height);
  }
  if (report.degenerate_triangles == report.triangles) report.smallest_height = 0.0;
  report.unused_vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
  const std::vector<bool> duplicate = duplicate_triangles(mesh);
  report.duplicate_triangles = static_cast<std::size_t>(std::count(duplicate.begin(), duplicate.end(), true));

  const std::vector<BadSide> bad = bad_sides(mesh, adjacency);
  const std::vector<std::uint32_t> links = two_sided_links(adjacency, bad);
  measure_edges(mesh, adjacency, bad, report);
  report.components = count_components(mesh.triangles.size(), links, bad);
  report.boundary_loops = count_boundary_loops(mesh, adjacency, links);
  report.non_manifold_vertices = count_non_manifold_vertices(mesh, adjacency);
  return report;
}

std::size_t triangles_narrower_than(const Mesh& mesh, double cell_size) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) count += shape_of(mesh, t).height < cell_size;
  return count;
}

}  // namespace verdigris
