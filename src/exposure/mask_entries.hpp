#pragma once
// What the files of entries add to the catalogue of masks.

#include "verdigris/exposure/mask_catalogue.hpp"

namespace verdigris {

void add_openness(MaskCatalogue& catalogue);
void add_shape(MaskCatalogue& catalogue);
void add_water(MaskCatalogue& catalogue);

}  // namespace verdigris
