#include "mask_entries.hpp"
#include "verdigris/exposure/lie.hpp"
#include "verdigris/exposure/openness.hpp"

namespace verdigris {

namespace {

struct RayParameters {
  RaySettings settings{};

  template <typename V>
  void parameters(V&& v) {
    v("rays", settings.rays, 16, 65536, "1", "rays of a sample; the error halves with twice as many");
    v("tolerance", settings.tolerance, 1e-4, 1.0, "1", "samples lie closer where the mask changes by more");
    v("finest", settings.finest, 0.0, 1e9, "unit", "least distance of samples; 0: three cells");
  }
  RaySettings with(std::uint64_t seed) const {
    RaySettings s = settings;
    s.seed = seed;
    return s;
  }
};

struct AoMask {
  static constexpr const char *name = "ao", *unit = "1",
                              *summary = "ambient occlusion: 1 in the open, 0 enclosed";
  RayParameters rays{};

  template <typename V>
  void parameters(V&& v) {
    rays.parameters(v);
  }
  Field<float> make(const Surface& surface, std::uint64_t seed) const {
    return ambient_occlusion(surface, rays.with(seed));
  }
};

struct SkyMask {
  static constexpr const char *name = "sky", *unit = "1",
                              *summary = "sky view factor: 1 on open level ground, 0 where no sky is seen";
  std::string up = "y";
  RayParameters rays{};

  template <typename V>
  void parameters(V&& v) {
    v("up", up, {}, "direction of the sky: an axis or three numbers");
    rays.parameters(v);
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    return exposures.sky_view(parse_direction(up, "sky.up"), rays.with(seed));
  }
};

struct RainMask {
  static constexpr const char *name = "rain", *unit = "1", *summary = "how much rain hits the place";
  std::string from = "y";
  double spread = 10.0;
  RayParameters rays{};

  template <typename V>
  void parameters(V&& v) {
    v("from", from, {}, "where the rain comes from: an axis or three numbers");
    v("spread", spread, 0.0, 89.0, "degree", "half the opening of the cone that drops come in");
    rays.parameters(v);
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    return exposures.rain_exposure({parse_direction(from, "rain.from"), spread}, rays.with(seed));
  }
};

}  // namespace

void add_openness(MaskCatalogue& catalogue) {
  catalogue.add(mask_entry<AoMask>());
  catalogue.add(mask_entry<SkyMask>());
  catalogue.add(mask_entry<RainMask>());
}

}  // namespace verdigris
