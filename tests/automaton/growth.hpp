#pragma once
// Growth from one seed at the origin, for tests that measure it.

#include <array>

#include "shapes.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#include "verdigris/surface/owned_cells.hpp"

namespace growth {

using namespace verdigris;

inline std::uint32_t slot_at(const Surface& surface, glm::dvec3 point) {
  return locate(surface, std::array<glm::dvec3, 1>{point})[0].slot;
}

inline VoronoiGrowth from_point(const Surface& surface, glm::dvec3 point, std::uint64_t seed) {
  SimulationSetup setup{surface, seed, {}, {}};
  setup.seeds = {{slot_at(surface, point), 1.0}};
  return VoronoiGrowth(setup, {});
}

}  // namespace growth
