#pragma once
// What a place sees of its surroundings, by rays: how open it is, how much sky it sees, how much rain falls
// on it.

#include <cstdint>
#include <glm/vec3.hpp>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// How rays are spent. They start at samples of the surface: the vertices, and points between them where the
/// result changes; cells take what they interpolate to. Rays of a sample depend on the seed and on the
/// sample only.
struct RaySettings {
  int rays = 384;              ///< a sample, >= 16; a quarter where those agree. The error goes as 1 / rays
  double tolerance = 0.05;     ///< edges whose ends differ by more are halved ...
  double finest = 0.0;         ///< ... down to this length, model units; 0: three cells
  double crease_angle = 40.0;  ///< degrees; the surface counts as smooth up to it
  std::uint64_t seed = 1;
};

/// Ambient occlusion, [slot] 0..1: the cosine-weighted share of the directions about the normal in which the
/// model itself is not met (Zhukov, Iones & Kronin 1998; Landis 2002). 1 is open, 0 enclosed. Like all masks
/// here it has ghosts filled, is the same to the bit for any number of threads, and throws InputError for
/// settings out of range.
Field<float> ambient_occlusion(const Surface& surface, const RaySettings& rays = {});

/// Sky view factor, [slot] 0..1: the cosine-weighted share of directions that meet the sky, the half space
/// towards `up` (unit): 1 on open level ground, 1/2 on a free wall, 0 on an underside.
Field<float> sky_view(const Surface& surface, glm::dvec3 up = {0.0, 1.0, 0.0}, const RaySettings& rays = {});

/// Where rain comes from.
struct RainDirection {
  glm::dvec3 towards{0.0, 1.0, 0.0};  ///< from the ground to where the drops come from, any length > 0
  double spread = 10.0;               ///< degrees, 0..89: half the opening of the cone they come in, gusts
};

/// Rain that hits the surface, [slot] 0..1, relative to what a plane square to it takes: the mean over the
/// cone of visibility times the cosine to the normal.
Field<float> rain_exposure(const Surface& surface, const RainDirection& rain = {},
                           const RaySettings& rays = {});

}  // namespace verdigris
