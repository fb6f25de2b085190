#include "ground.hpp"

#include <algorithm>

#include "verdigris/exposure/openness.hpp"
#include "verdigris/exposure/surface_field.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"

using namespace verdigris;

namespace {

std::vector<std::uint8_t> bytes_of(const Surface& surface, const Field<float>& values) {
  std::vector<std::uint8_t> bytes(values.size());
  std::transform(values.begin(), values.end(), bytes.begin(), [](float v) {
    return static_cast<std::uint8_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f);
  });
  copy_to_ghosts(surface, bytes);
  return bytes;
}

// No patina is of one colour: blotches from a seventh of the model down to the cells.
std::vector<std::uint8_t> blotches(const Surface& surface, std::uint64_t seed) {
  Fbm noise;
  noise.lattice.frequency = 7.0;
  noise.series.H = 0.45;
  Field<float> values = field_on_surface(surface, *noise.make(seed));
  stretch_to_unit(values, -0.4, 0.4);
  return bytes_of(surface, values);
}

}  // namespace

PatinaGround make_ground(const Surface& surface, std::uint64_t seed, bool occlusion) {
  PatinaGround ground;
  ground.tints = blotches(surface, seed);
  if (occlusion) ground.open = bytes_of(surface, ambient_occlusion(surface, {.rays = 64, .tolerance = 0.06}));
  return ground;
}
