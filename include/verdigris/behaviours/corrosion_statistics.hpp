#pragma once
// Corrosion in numbers, as a laboratory would report it.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "verdigris/automaton/spots.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/material/material.hpp"

namespace verdigris {

/// What a step means in the world, and how deep a corroded cell is.
struct CorrosionScale {
  double step_years = 1.0;  ///< length of a step
  double density = 8.96;    ///< of the metal, g/cm3
  /// Metal lost, micrometres, of a cell of this age in steps, at this rate (mask "rate", 0..1).
  std::function<double(std::uint64_t age, double rate)> depth;
  double metal = 1000.0;  ///< micrometres; a cell as deep as that does not exist any more
};

/// The linear law of the simulation itself.
CorrosionScale scale_of(const CorrosionGrowth& growth, double step_years, double density);

/// The law of a material. Its metal may end at another age than the simulation's, see with_lifetime.
CorrosionScale scale_of(const Material& material, ExposureClass exposure, double step_years);

/// Parameters whose cells lose their metal at the age at which the material's do, linearly in time.
CorrosionParameters with_lifetime(CorrosionParameters parameters, const Material& material,
                                  ExposureClass exposure, double step_years);

/// Numbers at the end of a step.
struct CorrosionNumbers {
  std::uint64_t step = 0;
  double years = 0.0;
  std::uint64_t new_cells = 0;       ///< corroded in this step
  std::uint64_t corroded = 0;        ///< cells that have corroded so far, those without metal included
  std::uint64_t gone = 0;            ///< of these, cells without metal
  double share = 0.0;                ///< corroded, of all owned cells
  double mean_depth = 0.0;           ///< micrometres, over all cells
  double mean_depth_corroded = 0.0;  ///< micrometres, over corroded cells
  double greatest_depth = 0.0;       ///< micrometres
  double mass_loss = 0.0;            ///< g/m2, over the whole surface
  std::optional<Spots> spots;        ///< where they were asked for
};

/// Takes the numbers of a running simulation, from its counts of births: a step costs as much as steps have
/// been made, whatever the number of cells. Spots take a pass over the cells.
class CorrosionStatistics {
 public:
  explicit CorrosionStatistics(CorrosionScale scale) : scale_(std::move(scale)) {}

  CorrosionNumbers measure(const CorrosionGrowth& growth, bool with_spots = false) {
    return measure_at(growth, growth.steps(), with_spots);
  }
  /// The same as they were after an earlier step: cells remember when they corroded.
  CorrosionNumbers measure_at(const CorrosionGrowth& growth, std::uint64_t step, bool with_spots = false);

 private:
  CorrosionScale scale_;
  std::array<std::vector<double>, 256> depth_at_age_;  // [rate * 255][age in steps]
};

/// The spots of corrosion as they are now, or were after step `at`.
Spots measure_spots(const CorrosionGrowth& growth);
Spots measure_spots(const CorrosionGrowth& growth, std::uint64_t at);

}  // namespace verdigris
