#pragma once
// The part of a scene that gives corrosion a material, a climate and a clock.

#include <string>
#include <vector>

namespace verdigris {

/// Table [corrosion] of a scene. Without a material there is none.
struct CorrosionPlan {
  std::string material;         ///< a name that find_material knows, or a file that ends in .toml
  std::string exposure = "C3";  ///< class of ISO 9223, C1 to CX
  double step_years = 0.0;      ///< length of a step
  std::vector<double> frames;   ///< ages to draw, years
  double exaggerate = 1.0;      ///< factor on the relief; 0: none
  double unit_mm = 0.0;         ///< length of a model unit, millimetres; 0: told by the size of the model
  bool holes = false;           ///< cells without metal are not drawn; else what lies under the metal is
  bool occlusion = true;        ///< darken what sees little of its surroundings

  bool empty() const { return material.empty(); }
};

}  // namespace verdigris
