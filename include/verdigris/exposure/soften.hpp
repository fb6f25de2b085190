#pragma once
// Taking the grain of single cells out of a field.

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The binomial mean (1 2 1; 2 4 2; 1 2 1) over the cells around, `passes` times; what lies beyond a boundary
/// has no part in it. Ghosts are filled, other slots hold 0. Needs unfolded links.
void soften(const Surface& surface, Field<float>& field, int passes);

}  // namespace verdigris
