#pragma once
// A coated metal as what pictures need: looks, depths and heights.

#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/picture/layers.hpp"
#include "verdigris/weathering/coated_metal.hpp"

namespace verdigris {

/// What cells look like and how.
struct CoatPicture {
  LayerStack stack;
  std::vector<LayerCell> cells;  ///< [slot], ghosts included
};

/// The coats from the uppermost down. Coats that lie nowhere are left out. Where there are more than
/// most_layers, coats of one finish are made one, at the place of the upper: the lower counts for as much as
/// is seen of it (e^-A of what is between); if that does not do, the thinnest are left out. Ghosts of the
/// state do not count. `tints` and
/// `open` [slot] are as in PatinaGround, or empty; cracks and scratches see less of their surroundings.
CoatPicture picture_of(const Surface& surface, const CoatedMetal& metal,
                       std::span<const std::uint8_t> tints = {}, std::span<const std::uint8_t> open = {});

/// [slot] how far owned cells stand out over bright metal, micrometres.
std::vector<float> coat_heights(const Surface& surface, const CoatedMetal& metal);

}  // namespace verdigris
