// Normal cycle: Cohen-Steiner & Morvan 2003, "Restricted Delaunay triangulations and normal cycle". Heat
// flow on a triangle mesh, implicit in time: Desbrun et al. 1999, "Implicit fairing of irregular meshes".

#include "verdigris/exposure/curvature.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "heat_flow.hpp"
#include "sample_mesh.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

struct EdgeSide {
  std::uint64_t key;
  std::uint32_t piece;
};

// Angle by which the faces of two pieces turn at their common edge (a, b), positive where convex.
double turning_angle(const Surface& surface, const SampleMesh& mesh, const SampleMesh::Piece& p,
                     const SampleMesh::Piece& q) {
  const Frame &f = surface.frame(p.patch), &g = surface.frame(q.patch);
  if (p.patch == q.patch || f.cy <= 0.0 || g.cy <= 0.0) return 0.0;
  const glm::dvec3 m = f.normal(), n = g.normal();
  const auto middle = [&](const SampleMesh::Piece& piece) {
    return (mesh.samples()[piece.samples[0]].position + mesh.samples()[piece.samples[1]].position +
            mesh.samples()[piece.samples[2]].position) /
           3.0;
  };
  const double angle = std::atan2(glm::length(glm::cross(m, n)), glm::dot(m, n));
  return glm::dot(middle(q) - middle(p), m) <= 0.0 ? angle : -angle;
}

// Curvature held by the edges around each sample, 1 x model unit.
std::vector<double> edge_curvature(const Surface& surface, const SampleMesh& mesh) {
  std::vector<EdgeSide> sides;
  const auto& pieces = mesh.pieces();
  for (std::uint32_t p = 0; p < pieces.size(); ++p)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = pieces[p].samples[k], b = pieces[p].samples[(k + 1) % 3];
      sides.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), p});
    }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& x, const EdgeSide& y) {
    return x.key != y.key ? x.key < y.key : x.piece < y.piece;
  });
  std::vector<double> held(mesh.samples().size(), 0.0);
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    if (sides[k].key != sides[k + 1].key) continue;
    const auto a = static_cast<std::uint32_t>(sides[k].key >> 32),
               b = static_cast<std::uint32_t>(sides[k].key);
    const double angle = turning_angle(surface, mesh, pieces[sides[k].piece], pieces[sides[k + 1].piece]);
    const double share = 0.25 * angle * mesh.edge_length(a, b);
    held[a] += share;
    held[b] += share;
  }
  return held;
}

}  // namespace

double default_radius(const Surface& surface) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  return std::max(0.01 * glm::length(bounds.upper - bounds.lower), 1.5 * surface.cell_size());
}

Field<float> mean_curvature(const Surface& surface, double radius) {
  if (!(radius > 0.0) || !std::isfinite(radius))
    throw InputError("curvature radius", std::to_string(radius) + " is no length",
                     "give a length above 0 in model units");
  SampleMesh mesh(surface, 181.0);
  // Finer than cells nothing can be seen.
  mesh.refine_to(std::max(0.7 * radius, surface.cell_size()));
  const std::vector<double> curvature = spread_by_heat(mesh, edge_curvature(surface, mesh), radius);
  return values_at_cells(surface, mesh, std::vector<float>(curvature.begin(), curvature.end()));
}

namespace {
Field<float> bent(const Surface& surface, double radius, double sign) {
  Field<float> field = mean_curvature(surface, radius);
  tbb::parallel_for(std::size_t{0}, field.size(), [&](std::size_t slot) {
    const double h = std::max(0.0, sign * field[slot] * radius);
    field[slot] = static_cast<float>(1.0 - std::exp(-4.0 * h));
  });
  return field;
}
}  // namespace

Field<float> convexity(const Surface& surface, double radius) {
  return bent(surface, radius, 1.0);
}

Field<float> concavity(const Surface& surface, double radius) {
  return bent(surface, radius, -1.0);
}

}  // namespace verdigris
