#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "verdigris/base/error.hpp"
#include "verdigris/exposure/soften.hpp"
#include "verdigris/exposure/water.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

WaterResult run_water(const Surface& surface, const WaterPaths& paths, std::span<const float> rain,
                      std::span<const float> source, const StormSettings& settings) {
  if (rain.size() != surface.slot_count() || (!source.empty() && source.size() != surface.slot_count()) ||
      paths.slots.size() != surface.owned_count())
    throw std::invalid_argument("a field of another surface");
  if (!(settings.film >= 0.0) || !(settings.wetting_flow >= 0.0) || !(settings.deposit_length >= 0.0))
    throw InputError("rain", "film, wetting flow or deposit length is below 0",
                     "use 0 for what suits the model");
  const Bounds bounds = mesh_bounds(surface.mesh());
  const double diagonal = glm::length(bounds.upper - bounds.lower);
  const double wetting = settings.wetting_flow > 0.0 ? settings.wetting_flow : 0.1 * diagonal;
  const double settling = settings.deposit_length > 0.0 ? settings.deposit_length : 0.25 * diagonal;
  const double area = paths.cell_size * paths.cell_size;

  WaterResult result;
  for (Field<float>* field : {&result.flow, &result.stored, &result.wetness, &result.stain})
    field->assign(surface.slot_count(), 0.0f);
  WaterBalance& balance = result.balance;
  std::vector<double> water(paths.cells.size(), 0.0), carried(source.empty() ? 0 : paths.cells.size(), 0.0);
  for (std::size_t k = 0; k < paths.cells.size(); ++k) {
    const WaterPaths::Cell& cell = paths.cells[k];
    const std::uint32_t slot = paths.slots[k];
    const double rained = std::max(0.0, static_cast<double>(rain[slot])) * area;
    balance.rained += rained;
    const double in = water[k] + rained;
    double stored = std::min(in, settings.film * area), out = in - stored;
    double load = 0.0, laid = 0.0;
    if (!carried.empty()) {
      const double dissolved = std::max(0.0, static_cast<double>(source[slot])) * in;
      balance.dissolved += dissolved;
      load = carried[k] + dissolved;
      laid = load * (1.0 - std::exp(-cell.length / settling));
      load -= laid;
    }
    // Hands on a part of what is left; `load` goes with the water.
    const double all_water = out, all_load = load;
    const auto give = [&](std::uint32_t to, double w, double l) {
      out -= w;
      load -= l;
      if (to == WaterPaths::stays) {
        stored += w;
        laid += l;
      } else if (to == WaterPaths::dripped || to == WaterPaths::drained) {
        (to == WaterPaths::dripped ? balance.dripped : balance.drained) += w;
        balance.carried_off += l;
      } else {
        water[to] += w;
        if (!carried.empty()) carried[to] += l;
      }
    };
    const double drips = cell.drip_share;
    if (drips > 0.0) give(cell.drip_to, drips * all_water, drips * all_load);
    const double rest_water = out, rest_load = load;
    for (int j = 3; j > 0; --j)
      if (cell.share[j] > 0.0f) give(cell.to[j], cell.share[j] * rest_water, cell.share[j] * rest_load);
    give(cell.to[0], out, load);  // what is left, so that nothing is lost to rounding
    balance.stored += stored;
    balance.deposited += laid;
    const double flow = in / area * std::max(static_cast<double>(cell.length), paths.cell_size);
    result.flow[slot] = static_cast<float>(flow);
    result.stored[slot] = static_cast<float>(stored / area);
    result.stain[slot] = static_cast<float>(laid / area);
  }
  // Water goes from cell to cell in steps of more than one: what it passes over is wet too.
  constexpr int passes = 2;
  soften(surface, result.flow, passes);
  soften(surface, result.stain, passes);
  copy_to_ghosts(surface, result.stored);
  for (std::size_t slot = 0; slot < result.flow.size(); ++slot)
    result.wetness[slot] =
        static_cast<float>(1.0 - std::exp(-static_cast<double>(result.flow[slot]) / wetting));
  return result;
}

}  // namespace verdigris
