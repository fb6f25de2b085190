#pragma once
// Growth from one seed at the origin, for tests that measure it.

#include <array>

#include "shapes.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"

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

template <typename Visit>
void for_owned(const Surface& surface, Visit&& visit) {
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot) visit(slot);
}

}  // namespace growth
