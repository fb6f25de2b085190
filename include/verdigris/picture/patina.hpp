#pragma once
// A material's layers as what pictures need: looks, and depths and heights from the ages of cells.

#include <cstdint>
#include <span>
#include <vector>

#include "verdigris/material/material.hpp"
#include "verdigris/picture/layers.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// The look of a finish: colour, highlight and mirror image.
LayerLook look_of(const Finish& finish);

/// The looks of a material, its layers from the uppermost down. Throws InputError when it has more layers
/// than most_layers.
LayerStack looks_of(const Material& material);

/// When the cells of a surface corroded, and how time runs: all that layers are a closed form of.
struct PatinaAges {
  std::span<const std::int32_t> arrivals;  ///< [slot] step in which it corroded; -1: sound
  std::span<const std::uint8_t> rates;     ///< [slot] speed of all laws, 255: 1; or empty: 1
  ExposureClass exposure = ExposureClass::C3;
  double years_a_step = 0.03;
  double now = 0.0;  ///< years since the first step; cells that corrode later are sound
};

/// What stays the same over all ages: LayerCell::tint and open, [slot], or empty.
struct PatinaGround {
  std::vector<std::uint8_t> tints, open;
};

/// [slot] the layers of each cell, ghosts included; a cell whose metal is gone is not present.
std::vector<LayerCell> patina_cells(const Material& material, const PatinaAges& ages,
                                    const PatinaGround& ground = {});

/// [slot] how far each cell stands out over a sound one, in micrometres: what its layers have grown by, less
/// the metal lost.
std::vector<float> patina_heights(const Material& material, const PatinaAges& ages);

}  // namespace verdigris
