#pragma once
// What each family of primitives adds to the catalogue.

#include "verdigris/synthesis/primitive_catalogue.hpp"

namespace verdigris {

void add_noise(PrimitiveCatalogue& catalogue);
void add_midpoint(PrimitiveCatalogue& catalogue);
void add_function_systems(PrimitiveCatalogue& catalogue);
void add_escape_time(PrimitiveCatalogue& catalogue);
void add_lsystems(PrimitiveCatalogue& catalogue);

}  // namespace verdigris
