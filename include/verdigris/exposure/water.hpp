#pragma once
// Rain that runs down the surface, joins, drips from overhangs and leaves its marks.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// How water finds its way.
struct WaterPathSettings {
  glm::dvec3 up{0.0, 1.0, 0.0};  ///< any length > 0
  double meander = 0.0;       ///< degrees, 0..60: how far roughness turns water off the steepest way (typical
                              ///< deviation); it makes rivulets. 0: straight down
  double meander_size = 0.0;  ///< size of that roughness, model units; 0: twelve cells
  double drip_length = 0.0;   ///< model units: below a level ceiling, 1 - 1/e of the water has dripped after
                              ///< this; 0: a twentieth of the diagonal of the bounds
  double rim_share =
      0.5;  ///< 0..1: of what reaches a sharp lower rim drips, the rest clings to its underside
  std::uint64_t seed = 1;  ///< of the roughness
};

/// Where the water of each owned cell goes, made once for a surface. Cells stand from the highest to the
/// lowest, and water only ever goes to cells that stand later: it never rises.
struct WaterPaths {
  static constexpr std::uint32_t stays = 0xFFFFFFFFu;    ///< in a hollow
  static constexpr std::uint32_t dripped = 0xFFFFFFFEu;  ///< off the model, falling
  static constexpr std::uint32_t drained = 0xFFFFFFFDu;  ///< off the model, over an open edge
  struct Cell {
    std::array<std::uint32_t, 4> to;  ///< index into `cells`, or one of the above
    std::array<float, 4> share;       ///< of what does not drip; sums to 1
    std::uint32_t drip_to;            ///< where drops land
    float drip_share;                 ///< of all
    float length;                     ///< of the way to the next cells, model units
  };
  std::vector<std::uint32_t> slots;  ///< [cell]
  std::vector<Cell> cells;
  double cell_size = 0.0;
};

/// Follows the steepest way from each cell, straight down in the planes of triangles, along edges where two
/// slopes meet, over edges by unfolding, for a cell and a half or as far as it takes to come lower; shares
/// the water among the cells around that point so that its mean goes there (cf. Tarboton 1997, D-infinity).
/// From ceilings it drips, straight down to what lies below. Throws InputError for settings out of range and
/// with projected links. In parallel, the same bits for any number of threads.
WaterPaths make_water_paths(const Surface& surface, const WaterPathSettings& settings = {});

/// One rain.
struct StormSettings {
  double film = 0.05;  ///< depth that stays on every cell it reaches, >= 0; rain of exposure 1 is 1 deep
  double wetting_flow = 0.0;    ///< flow at which wetness is 1 - 1/e, depth x model units; 0: a tenth of the
                                ///< diagonal of the bounds
  double deposit_length = 0.0;  ///< model units in which water lays down 1 - 1/e of what it carries; 0: a
                                ///< quarter of the diagonal
};

/// Volumes are depth x model units squared; of stains, that times the source's units.
struct WaterBalance {
  double rained = 0.0, stored = 0.0, dripped = 0.0, drained = 0.0;
  double dissolved = 0.0, deposited = 0.0, carried_off = 0.0;
};

/// What a rain leaves, [slot], ghosts included. Flow and stain are softened over the next cells.
struct WaterResult {
  Field<float> flow;     ///< that passed, depth x model units: volume a unit of width
  Field<float> stored;   ///< film and what stands in hollows, depth
  Field<float> wetness;  ///< 0..1: 1 - exp(-flow / wetting_flow)
  Field<float> stain;    ///< what was laid down, source's units x depth
  WaterBalance balance;
};

/// Lets it rain: `rain` [slot] is how deep (rain_exposure), `source` [slot] what a unit of water dissolves
/// there (empty: nothing). Both >= 0, what is less counts as 0. One pass from the highest cell to the lowest,
/// in one thread; rained = stored + dripped + drained to rounding. Throws std::invalid_argument when a field
/// has another size than the surface's, InputError for settings out of range.
WaterResult run_water(const Surface& surface, const WaterPaths& paths, std::span<const float> rain,
                      std::span<const float> source = {}, const StormSettings& settings = {});

}  // namespace verdigris
