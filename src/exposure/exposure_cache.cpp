#include "verdigris/exposure/exposure_cache.hpp"

namespace verdigris {

namespace {

// Seeds go in two halves, which doubles hold exactly.
void add_seed(std::vector<double>& key, std::uint64_t seed) {
  key.push_back(static_cast<double>(seed >> 32));
  key.push_back(static_cast<double>(seed & 0xFFFFFFFFu));
}

std::vector<double> key_of(glm::dvec3 direction, const RaySettings& rays) {
  std::vector<double> key{direction.x,    direction.y, direction.z,      static_cast<double>(rays.rays),
                          rays.tolerance, rays.finest, rays.crease_angle};
  add_seed(key, rays.seed);
  return key;
}

// The value under `key`, made by `make` when there is none.
template <typename Value, typename Make>
const Value& kept(std::map<std::vector<double>, Value>& values, std::vector<double> key, Make&& make) {
  if (const auto found = values.find(key); found != values.end()) return found->second;
  return values.emplace(std::move(key), make()).first->second;
}

}  // namespace

const Field<float>& ExposureCache::sky_view(glm::dvec3 up, const RaySettings& rays) {
  return kept(sky_, key_of(up, rays), [&] { return verdigris::sky_view(surface_, up, rays); });
}

const Field<float>& ExposureCache::rain_exposure(const RainDirection& rain, const RaySettings& rays) {
  std::vector<double> key = key_of(rain.towards, rays);
  key.push_back(rain.spread);
  return kept(rain_, std::move(key), [&] { return verdigris::rain_exposure(surface_, rain, rays); });
}

const WaterPaths& ExposureCache::water_paths(const WaterPathSettings& s) {
  std::vector<double> key{s.up.x, s.up.y, s.up.z, s.meander, s.meander_size, s.drip_length, s.rim_share};
  add_seed(key, s.meander > 0.0 ? s.seed : 0);  // only meanders are drawn by lot
  return kept(water_, std::move(key), [&] { return make_water_paths(surface_, s); });
}

}  // namespace verdigris
