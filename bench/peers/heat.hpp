#pragma once
// CGAL's heat method as a partition: one solve a seed, each vertex to the seed that is nearest.

#include <cstdint>
#include <vector>

#include "verdigris/mesh/mesh.hpp"

namespace bench {

struct HeatTimes {
  double factor = 0.0, solves = 0.0;  ///< seconds
  std::vector<std::int32_t> labels;   ///< [vertex]
};
HeatTimes heat_partition(const verdigris::Mesh& mesh, const std::vector<std::uint32_t>& seeds);

}  // namespace bench
