#include "heat.hpp"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <chrono>
#include <limits>

namespace bench {

HeatTimes heat_partition(const verdigris::Mesh& mesh, const std::vector<std::uint32_t>& seeds) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Model = CGAL::Surface_mesh<Kernel::Point_3>;
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point from) {
    return std::chrono::duration<double>(Clock::now() - from).count();
  };
  Model model;
  std::vector<Model::Vertex_index> vertices;
  for (const auto& p : mesh.positions) vertices.push_back(model.add_vertex({p.x, p.y, p.z}));
  for (const auto& t : mesh.triangles) model.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);

  HeatTimes times;
  auto begin = Clock::now();
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Model> heat(model);
  auto distance = model.add_property_map<Model::Vertex_index, double>("v:distance", 0.0).first;
  // The first solve factors the matrices.
  heat.add_source(vertices[seeds[0]]);
  heat.estimate_geodesic_distances(distance);
  times.factor = seconds(begin);
  std::vector<double> nearest(vertices.size(), std::numeric_limits<double>::infinity());
  times.labels.assign(vertices.size(), -1);
  begin = Clock::now();
  for (std::size_t k = 0; k < seeds.size(); ++k) {
    heat.clear_sources();
    heat.add_source(vertices[seeds[k]]);
    heat.estimate_geodesic_distances(distance);
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (distance[vertices[v]] < nearest[v]) {
        nearest[v] = distance[vertices[v]];
        times.labels[v] = static_cast<std::int32_t>(k);
      }
  }
  times.solves = seconds(begin);
  return times;
}

}  // namespace bench
