#pragma once
// What has grown on each cell of a running corrosion: the stack of a material, computed when looked at.

#include <vector>

#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/material/material.hpp"

namespace verdigris {

/// Thicknesses, micrometres, for every slot (0 where there is no cell).
struct LayerFields {
  std::vector<Field<float>> layers;  ///< [layer of the material][slot], from the metal outwards
  Field<float> metal_lost;           ///< [slot]; material.thickness where no metal is left
};

/// The stack of `material` on each cell, a step taken as `step_years`. Sound cells show what lies on sound
/// metal. The mask "rate" multiplies the rates of all laws in its cells. Linear in the number of slots; the
/// laws are worked out once for each age that occurs.
LayerFields corrosion_layers(const CorrosionGrowth& growth, const Material& material, ExposureClass exposure,
                             double step_years);

}  // namespace verdigris
