#pragma once
// What each family of primitives adds to the catalogue.

#include "verdigris/synthesis/primitive_catalogue.hpp"

namespace verdigris {

void add_noise(PrimitiveCatalogue& catalogue);

}  // namespace verdigris
