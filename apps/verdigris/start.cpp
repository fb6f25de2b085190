#include "start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verdigris/base/error.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/exposure/mesh_values.hpp"
#include "verdigris/io/read_points.hpp"

using namespace verdigris;

PlacedSeeds place_seeds(const Surface& surface, const Scene& scene, std::size_t file_vertices,
                        const Field<std::uint8_t>& barrier) {
  PlacedSeeds placed;
  const SeedPlan& plan = scene.seeds;
  if (plan.empty()) return placed;
  if (plan.count > 0) {
    placed.seeds = random_seeds(surface, plan.count, scene.seed, barrier);
  } else {
    std::vector<glm::dvec3> points;
    for (const WeightedPoint& p : plan.points) points.push_back(p.position);
    const Mesh& mesh = surface.mesh();
    for (const std::uint32_t v : plan.vertices) {
      const std::size_t known =
          mesh.vertex_of_file.empty() ? mesh.positions.size() : mesh.vertex_of_file.size();
      if (v >= known)
        throw InputError("seeds", fmt::format("there is no vertex {}", v),
                         fmt::format("the file has {} vertices, counted from 0", file_vertices));
      points.push_back(mesh.positions[mesh.vertex_of_file.empty() ? v : mesh.vertex_of_file[v]]);
    }
    if (points.size() > surface.owned_count())
      throw InputError("seeds", fmt::format("{} seeds for {} cells", points.size(), surface.owned_count()),
                       "give fewer seeds, or use smaller cells");
    for (const LocatedCell& cell : locate(surface, points)) {
      placed.seeds.push_back({cell.slot, 1.0});
      placed.farthest = std::max(placed.farthest, cell.distance);
    }
    for (std::size_t k = 0; k < plan.points.size(); ++k) placed.seeds[k].weight = plan.points[k].weight;
  }
  if (!plan.weights.empty()) {
    if (plan.weights.size() != placed.seeds.size())
      throw InputError("seeds",
                       fmt::format("{} weights for {} seeds", plan.weights.size(), placed.seeds.size()),
                       "give one weight for each seed");
    for (std::size_t k = 0; k < placed.seeds.size(); ++k) placed.seeds[k].weight = plan.weights[k];
  }
  return placed;
}

Field<std::uint8_t> barred_by(const Surface& surface, const Field<float>& mask, double threshold) {
  Field<std::uint8_t> barrier(mask.size(), 0);
  for (const Row& row : surface.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
      barrier[slot] = mask[slot] >= static_cast<float>(threshold);
  return barrier;
}

Field<std::uint8_t> make_barrier(const Surface& surface, const Scene& scene, const ReadReport& read) {
  if (scene.barrier.mask.empty()) return {};
  const Field<float> mask = file_values(surface, read_numbers(scene.barrier.mask), read.file_vertices,
                                        read.file_faces, scene.barrier.mask_on, scene.barrier.mask.string());
  return barred_by(surface, mask, scene.barrier.threshold);
}
