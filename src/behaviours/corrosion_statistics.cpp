#include "verdigris/behaviours/corrosion_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace verdigris {

CorrosionScale scale_of(const CorrosionGrowth& growth, double step_years, double density) {
  const LinearThickness law = growth.parameters().thickness;
  return {step_years, density, [law](std::uint64_t age, double rate) { return law.depth(age, rate); },
          law.metal};
}

CorrosionScale scale_of(const Material& material, ExposureClass exposure, double step_years) {
  return {step_years, material.density,
          [material, exposure, step_years](std::uint64_t age, double rate) {
            return metal_loss(material, exposure, static_cast<double>(age) * step_years, rate);
          },
          material.thickness};
}

CorrosionParameters with_lifetime(CorrosionParameters parameters, const Material& material,
                                  ExposureClass exposure, double step_years) {
  parameters.thickness.metal = material.thickness;
  parameters.thickness.k1 = material.thickness * step_years / metal_lifetime(material, exposure);
  return parameters;
}

CorrosionNumbers CorrosionStatistics::measure_at(const CorrosionGrowth& growth, std::uint64_t step,
                                                 bool with_spots) {
  CorrosionNumbers numbers;
  numbers.step = step;
  numbers.years = static_cast<double>(numbers.step) * scale_.step_years;
  numbers.new_cells = growth.births().at(step);
  const auto depth = [&](std::uint64_t age, double rate) {
    // Laws take powers; ages and rates come again and again.
    std::vector<double>& known = depth_at_age_[static_cast<std::size_t>(std::lround(rate * 255.0))];
    while (known.size() <= age) known.push_back(scale_.depth(known.size(), rate));
    return known[age];
  };
  double sum = 0.0;
  growth.visit_cohorts(step, [&](std::uint64_t age, double rate, std::uint64_t cells) {
    const double d = depth(age, rate);
    sum += d * static_cast<double>(cells);
    numbers.corroded += cells;
    if (d >= scale_.metal) numbers.gone += cells;
    numbers.greatest_depth = std::max(numbers.greatest_depth, d);
  });
  const auto cells = static_cast<double>(growth.surface().owned_count());
  numbers.share = static_cast<double>(numbers.corroded) / cells;
  numbers.mean_depth = sum / cells;
  if (numbers.corroded > 0) numbers.mean_depth_corroded = sum / static_cast<double>(numbers.corroded);
  numbers.mass_loss = mass_of(numbers.mean_depth, scale_.density);
  if (with_spots) numbers.spots = measure_spots(growth, step);
  return numbers;
}

Spots measure_spots(const CorrosionGrowth& growth) {
  return measure_spots(growth, growth.steps());
}

Spots measure_spots(const CorrosionGrowth& growth, std::uint64_t at) {
  const auto& words = growth.words();
  Field<SpotCell> cells(words.size());
  std::transform(words.begin(), words.end(), cells.begin(), [&](CorrosionRule::State word) {
    if (!CorrosionRule::corroded(word)) return CorrosionRule::sound(word) ? SpotCell::out : SpotCell::nothing;
    return CorrosionRule::birth(word) <= at ? SpotCell::in : SpotCell::out;
  });
  return measure_spots(growth.surface(), cells);
}

}  // namespace verdigris
