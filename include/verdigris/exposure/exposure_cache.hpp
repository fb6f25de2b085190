#pragma once
// What several masks and operators want to know of one surface, found once.

#include <map>
#include <vector>

#include "verdigris/exposure/openness.hpp"
#include "verdigris/exposure/water.hpp"

namespace verdigris {

/// Rain, sky and water of a surface by their settings, computed when first asked for and kept: a value for
/// one run, handed from mask to mask. What it returns stays where it is as long as the cache lives. For one
/// thread at a time; throws what the functions of these names throw.
class ExposureCache {
 public:
  /// The surface must outlive it.
  explicit ExposureCache(const Surface& surface) : surface_(surface) {}
  ExposureCache(const ExposureCache&) = delete;

  const Surface& surface() const { return surface_; }

  const Field<float>& sky_view(glm::dvec3 up, const RaySettings& rays);
  const Field<float>& rain_exposure(const RainDirection& rain, const RaySettings& rays);
  const WaterPaths& water_paths(const WaterPathSettings& settings);

 private:
  using Key = std::vector<double>;  // the settings, in order

  const Surface& surface_;
  std::map<Key, Field<float>> sky_, rain_;
  std::map<Key, WaterPaths> water_;
};

}  // namespace verdigris
