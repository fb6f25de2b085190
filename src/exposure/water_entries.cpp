#include <algorithm>

#include "mask_entries.hpp"
#include "verdigris/exposure/curvature.hpp"
#include "verdigris/exposure/lie.hpp"
#include "verdigris/exposure/openness.hpp"
#include "verdigris/exposure/water.hpp"

namespace verdigris {

namespace {

struct RunOff {
  std::string up = "y", from;
  double spread = 10.0;
  double meander = 15.0, meander_size = 0.0, film = 0.05, drip_length = 0.0, rim_share = 0.5;

  template <typename V>
  void parameters(V&& v) {
    v("up", up, {}, "which way is up: an axis or three numbers");
    v("from", from, {}, "where the rain comes from; empty: from above");
    v("spread", spread, 0.0, 89.0, "degree", "half the opening of the cone that drops come in");
    v("meander", meander, 0.0, 60.0, "degree", "how far roughness turns the water: makes rivulets");
    v("meander-size", meander_size, 0.0, 1e9, "unit", "size of that roughness; 0: twelve cells");
    v("film", film, 0.0, 1e6, "depth", "what stays on every wet cell; rain is 1 deep");
    v("drip-length", drip_length, 0.0, 1e9, "unit", "how far water clings to ceilings; 0: 1/20 of the model");
    v("rim-share", rim_share, 0.0, 1.0, "1", "of the water at a sharp lower rim, what drips from it");
  }
  WaterResult run(ExposureCache& exposures, std::uint64_t seed, std::span<const float> source,
                  StormSettings storm) const {
    const glm::dvec3 above = parse_direction(up, "up");
    const Field<float>& rain = exposures.rain_exposure(
        {from.empty() ? above : parse_direction(from, "from"), spread}, {.rays = 64, .seed = seed});
    const WaterPaths& paths = exposures.water_paths({.up = above,
                                                     .meander = meander,
                                                     .meander_size = meander_size,
                                                     .drip_length = drip_length,
                                                     .rim_share = rim_share,
                                                     .seed = seed});
    storm.film = film;
    return run_water(exposures.surface(), paths, rain, source, storm);
  }
};

struct WetnessMask {
  static constexpr const char *name = "wetness", *unit = "1",
                              *summary = "where rain runs: streaks, valleys, below what drips";
  RunOff water{};
  double wetting_flow = 0.0;

  template <typename V>
  void parameters(V&& v) {
    water.parameters(v);
    v("wetting-flow", wetting_flow, 0.0, 1e9, "unit", "flow that wets to 63 %; 0: a tenth of the model");
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    return water.run(exposures, seed, {}, {.wetting_flow = wetting_flow}).wetness;
  }
};

struct FlowMask {
  static constexpr const char *name = "flow", *unit = "unit",
                              *summary = "how much rain runs past, as a depth times the way it fell on";
  RunOff water{};

  template <typename V>
  void parameters(V&& v) {
    water.parameters(v);
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    return water.run(exposures, seed, {}, {}).flow;
  }
};

struct StoredMask {
  static constexpr const char *name = "stored", *unit = "depth",
                              *summary = "water that stays: film, and what stands in hollows";
  RunOff water{};

  template <typename V>
  void parameters(V&& v) {
    water.parameters(v);
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    return water.run(exposures, seed, {}, {}).stored;
  }
};

struct StainMask {
  static constexpr const char *name = "stain", *unit = "1",
                              *summary = "what water carries along and lays down, 1 at the strongest";
  RunOff water{};
  std::string source = "everywhere";
  double radius = 0.0, deposit_length = 0.0;

  template <typename V>
  void parameters(V&& v) {
    water.parameters(v);
    v("source", source, {"everywhere", "convex", "cavity"}, "where it is dissolved");
    v("radius", radius, 0.0, 1e9, "unit", "over which convex and cavity are seen; 0: 1/100 of the model");
    v("deposit-length", deposit_length, 0.0, 1e9, "unit", "how far it is carried; 0: a quarter of the model");
  }
  Field<float> make(ExposureCache& exposures, std::uint64_t seed) const {
    const Surface& surface = exposures.surface();
    const double r = radius > 0.0 ? radius : default_radius(surface);
    const Field<float> dissolves = source == "convex"   ? convexity(surface, r)
                                   : source == "cavity" ? concavity(surface, r)
                                                        : Field<float>(surface.slot_count(), 1.0f);
    Field<float> stain = water.run(exposures, seed, dissolves, {.deposit_length = deposit_length}).stain;
    // The strongest hundredth counts as full: single cells where water stands must not dim all others.
    std::vector<float> sorted;
    for (const float s : stain)
      if (s > 0.0f) sorted.push_back(s);
    if (sorted.empty()) return stain;
    const auto full = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 100 * 99);
    std::nth_element(sorted.begin(), full, sorted.end());
    for (float& s : stain) s = std::min(1.0f, s / *full);
    return stain;
  }
};

}  // namespace

void add_water(MaskCatalogue& catalogue) {
  catalogue.add(mask_entry<WetnessMask>());
  catalogue.add(mask_entry<FlowMask>());
  catalogue.add(mask_entry<StoredMask>());
  catalogue.add(mask_entry<StainMask>());
}

}  // namespace verdigris
