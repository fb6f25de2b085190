#include "fbm_heights.hpp"

#include "verdigris/synthesis/builtin.hpp"
#include "verdigris/synthesis/height_map.hpp"

std::vector<float> fbm_heights(double h, std::uint64_t seed, int width, int height, double section) {
  const auto field = verdigris::builtin_primitives().find("fbm").create({{"h", h}}, seed);
  return verdigris::sample_heights(*field, width, height, section).values;
}
