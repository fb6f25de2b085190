#include "verdigris/picture/coat_picture.hpp"

#include <algorithm>
#include <cmath>

#include "verdigris/picture/patina.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/surface/owned_cells.hpp"

namespace verdigris {

namespace {

// A layer of the picture while it is put together.
struct Drawn {
  LayerLook look;
  const Coat* coat;
  std::vector<float> depth;  // [slot] optical
  double seen = 0.0;         // sum of 1 - e^-depth
};

bool alike(const Coat& a, const Coat& b) {
  const Finish &x = a.layer.finish, &y = b.layer.finish;
  return x.colour == y.colour && x.roughness == y.roughness && x.metallic == y.metallic;
}

// Moves layer `lower` up to `upper`, as much of it as is seen there.
void merge(const Surface& surface, std::vector<Drawn>& layers, std::size_t upper, std::size_t lower) {
  for_owned(surface, [&](std::uint32_t slot) {
    float between = 0.0f;
    for (std::size_t k = upper + 1; k < lower; ++k) between += layers[k].depth[slot];
    layers[upper].depth[slot] += layers[lower].depth[slot] * std::exp(-between);
  });
  layers.erase(layers.begin() + static_cast<std::ptrdiff_t>(lower));
}

void reduce(const Surface& surface, std::vector<Drawn>& layers) {
  for (std::size_t upper = 0; upper < layers.size() && layers.size() > most_layers; ++upper)
    for (std::size_t lower = upper + 1; lower < layers.size() && layers.size() > most_layers; ++lower)
      if (alike(*layers[upper].coat, *layers[lower].coat)) merge(surface, layers, upper, lower--);
  if (layers.size() <= most_layers) return;
  for (Drawn& drawn : layers)
    for (const float depth : drawn.depth) drawn.seen += 1.0 - std::exp(-static_cast<double>(depth));
  while (layers.size() > most_layers)
    layers.erase(std::min_element(layers.begin(), layers.end(),
                                  [](const Drawn& a, const Drawn& b) { return a.seen < b.seen; }));
}

}  // namespace

CoatPicture picture_of(const Surface& surface, const CoatedMetal& metal, std::span<const std::uint8_t> tints,
                       std::span<const std::uint8_t> open) {
  const std::size_t slots = metal.loss.size();
  std::vector<Drawn> layers;
  for (auto coat = metal.coats.rbegin(); coat != metal.coats.rend(); ++coat) {
    Drawn drawn{look_of(coat->layer.finish), &*coat, std::vector<float>(slots), 0.0};
    drawn.look.opacity = static_cast<float>(coat->layer.opacity);
    drawn.look.clear_depth = static_cast<float>(coat->layer.unit);
    // Paint is of one colour, patina never.
    if (coat->kind == CoatKind::applied) drawn.look.far_colour = 1.06f * drawn.look.colour;
    for_owned(surface, [&](std::uint32_t slot) {
      drawn.depth[slot] = optical_depth(drawn.look, std::max(0.0f, coat->thickness[slot]));
    });
    if (std::any_of(drawn.depth.begin(), drawn.depth.end(), [](float depth) { return depth > 0.0f; }))
      layers.push_back(std::move(drawn));
  }
  reduce(surface, layers);
  CoatPicture picture;
  picture.stack.substrate = look_of(metal.metal.metal);
  for (const Drawn& drawn : layers) picture.stack.layers.push_back(drawn.look);
  picture.cells.resize(slots);
  for_owned(surface, [&](std::uint32_t slot) {
    LayerCell& cell = picture.cells[slot];
    for (std::size_t k = 0; k < layers.size(); ++k) cell.depth[k] = LayerCell::packed(layers[k].depth[slot]);
    cell.present = metal.gone(slot) ? 0 : 255;
    if (!tints.empty()) cell.tint = tints[slot];
    const float seen = open.empty() ? 255.0f : static_cast<float>(open[slot]);
    cell.open = static_cast<std::uint8_t>(seen * (1.0f - 0.5f * std::clamp(metal.damage[slot], 0.0f, 1.0f)));
  });
  copy_to_ghosts(surface, picture.cells);
  return picture;
}

std::vector<float> coat_heights(const Surface& surface, const CoatedMetal& metal) {
  std::vector<float> heights(metal.loss.size(), 0.0f);
  for_owned(surface, [&](std::uint32_t slot) {
    float height = -metal.loss[slot];
    for (const Coat& coat : metal.coats) height += coat.thickness[slot];
    heights[slot] = height;
  });
  return heights;
}

}  // namespace verdigris
