#pragma once
// What patina lies on: blotches, and how much each place sees of its surroundings.

#include "verdigris/picture/patina.hpp"
#include "verdigris/surface/surface.hpp"

/// Tints from noise of `seed`; `open` from ambient occlusion if it is wanted. Ghosts included.
verdigris::PatinaGround make_ground(const verdigris::Surface& surface, std::uint64_t seed, bool occlusion);
