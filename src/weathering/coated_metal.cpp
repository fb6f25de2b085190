#include "verdigris/weathering/coated_metal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cells.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

CoatedMetal make_coated_metal(const Surface& surface, const Material& material) {
  if (surface.link_kind() != LinkKind::unfolded)
    throw InputError("links", "weathering needs cells that see over edges", "use unfolded links");
  const std::size_t slots = surface.slot_count();
  CoatedMetal metal{
      material, Field<float>(slots, 0.0f), Field<float>(slots, -1.0f), Field<float>(slots, 0.0f), {}};
  for (const Layer& layer : material.layers) {
    const bool applied = layer.shrinks || layer.initial > 0.0;
    metal.coats.push_back({layer,
                           applied ? CoatKind::applied : CoatKind::product,
                           Field<float>(slots, static_cast<float>(layer.initial)),
                           {}});
  }
  return metal;
}

std::size_t find_coat(const CoatedMetal& metal, std::string_view name, std::string_view owner) {
  std::string known;
  for (std::size_t k = metal.coats.size(); k-- > 0;) {
    const Coat& coat = metal.coats[k];
    if (name.empty() ? coat.kind == CoatKind::applied : coat.layer.name == name) return k;
    known += (known.empty() ? "" : ", ") + coat.layer.name;
  }
  if (name.empty()) throw InputError(std::string(owner), "there is no coat yet", "put a coat on before");
  throw InputError(std::string(owner), fmt::format("there is no coat '{}'", name),
                   known.empty() ? "put a coat on before" : "the coats are: " + known);
}

float cover(const CoatedMetal& metal, std::uint32_t slot) {
  float sum = 0.0f;
  for (const Coat& coat : metal.coats)
    if (coat.kind == CoatKind::applied) sum += coat.thickness[slot];
  return sum;
}

float take_off(CoatedMetal& metal, std::uint32_t slot, float depth, std::size_t lowest) {
  float left = std::max(depth, 0.0f);
  const float asked = left;
  for (std::size_t k = metal.coats.size(); k-- > lowest && left > 0.0f;) {
    float& thickness = metal.coats[k].thickness[slot];
    const float taken = std::min(thickness, left);
    thickness -= taken;
    left -= taken;
  }
  return asked - left;
}

void show_ghosts(const Surface& surface, CoatedMetal& metal) {
  copy_to_ghosts(surface, metal.loss);
  copy_to_ghosts(surface, metal.corroded);
  copy_to_ghosts(surface, metal.damage);
  for (Coat& coat : metal.coats) {
    copy_to_ghosts(surface, coat.thickness);
    if (!coat.adhesion.empty()) copy_to_ghosts(surface, coat.adhesion);
  }
}

CoatedNumbers measure(const Surface& surface, const CoatedMetal& metal) {
  CoatedNumbers numbers;
  numbers.coats.assign(metal.coats.size(), 0.0);
  each_owned(surface, [&](std::uint32_t slot) {
    const double loss = metal.loss[slot];
    numbers.bare += cover(metal, slot) < bare_below;
    numbers.corroded += metal.corroded[slot] >= 0.0f;
    numbers.gone += metal.gone(slot);
    numbers.damaged += metal.damage[slot] > 0.0f;
    numbers.loss += loss;
    numbers.deepest = std::max(numbers.deepest, loss);
    for (std::size_t k = 0; k < metal.coats.size(); ++k)
      numbers.coats[k] += static_cast<double>(metal.coats[k].thickness[slot]);
  });
  const double cells = std::max(1.0, static_cast<double>(surface.owned_count()));
  for (double* sum : {&numbers.bare, &numbers.corroded, &numbers.gone, &numbers.damaged, &numbers.loss})
    *sum /= cells;
  for (double& sum : numbers.coats) sum /= cells;
  numbers.mass_loss = mass_of(numbers.loss, metal.metal.density);
  return numbers;
}

}  // namespace verdigris
