#pragma once
// The part of a scene that weathers a metal: what it is, and what happens to it.

#include <string>
#include <vector>

#include "verdigris/weathering/timeline.hpp"

namespace verdigris {

/// Table [weathering] and list [[timeline]] of a scene. Without a material there is none.
struct WeatheringPlan {
  std::string material;     ///< a name that find_material knows, or a file that ends in .toml
  double exaggerate = 1.0;  ///< factor on the relief; 0: none
  double unit_mm = 1.0;     ///< length of a model unit, millimetres
  bool occlusion = true;    ///< darken what sees little of its surroundings
  std::vector<TimelineStep> timeline;

  bool empty() const { return material.empty(); }
};

}  // namespace verdigris
