#include "verdigris/picture/patina.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verdigris/base/error.hpp"
#include "verdigris/picture/colour.hpp"

namespace verdigris {

LayerLook look_of(const Finish& finish) {
  LayerLook look;
  for (int k = 0; k < 3; ++k) look.colour[k] = srgb_to_linear(finish.colour[k]);
  // A crust pales where it is loose; a metal is of one colour.
  look.far_colour = (1.0f + 0.4f * (1.0f - finish.metallic)) * look.colour;
  const float smooth = 1.0f - finish.roughness;
  look.roughness = finish.roughness;
  look.metallic = finish.metallic;
  // Hardly any light enters a metal: nearly all that it sends is mirrored.
  look.ambient = 0.22f * (1.0f - finish.metallic) + 0.02f * finish.metallic;
  look.diffuse = 0.80f * (1.0f - finish.metallic) + (0.06f + 0.30f * finish.roughness) * finish.metallic;
  look.specular = 0.5f * finish.specular;
  look.shininess = std::max(finish.shininess, 1.0f);
  look.mirror =
      (1.0f - 0.35f * finish.roughness) * finish.metallic + 0.03f * smooth * (1.0f - finish.metallic);
  return look;
}

LayerStack looks_of(const Material& material) {
  if (material.layers.size() > most_layers)
    throw InputError(
        fmt::format("material {}", material.name),
        fmt::format("it has {} layers, and pictures hold {}", material.layers.size(), most_layers),
        "join some of them, or draw no picture");
  LayerStack stack;
  stack.substrate = look_of(material.metal);
  for (auto layer = material.layers.rbegin(); layer != material.layers.rend(); ++layer) {
    LayerLook look = look_of(layer->finish);
    look.opacity = static_cast<float>(layer->opacity);
    look.clear_depth = static_cast<float>(layer->unit);
    stack.layers.push_back(look);
  }
  return stack;
}

namespace {

// What cells of all ages look like, for each of the rates that occur: their laws are evaluated once an age,
// not once a cell. Index 0 is a sound cell, 1 + age one that has corroded.
template <typename T>
class AgeTable {
 public:
  template <typename Of>
  AgeTable(const PatinaAges& ages, const Of& of)
      : ages_(ages), now_(std::floor(ages.now / ages.years_a_step + 1e-9)) {
    std::array<bool, 256> used{};
    if (ages.rates.empty())
      used[255] = true;
    else
      for (const std::uint8_t rate : ages.rates) used[rate] = true;
    std::int32_t first = std::numeric_limits<std::int32_t>::max();
    for (const std::int32_t arrival : ages.arrivals)
      if (arrival >= 0) first = std::min(first, arrival);
    const double oldest = std::max(-1.0, now_ - first);
    count_ = 2 + static_cast<std::size_t>(std::max(0.0, oldest));
    for (std::size_t rate = 0; rate < 256; ++rate) {
      if (!used[rate]) continue;
      begin_[rate] = table_.size();
      table_.resize(table_.size() + count_);
      T* entries = table_.data() + begin_[rate];
      const double remainder = ages.now - now_ * ages.years_a_step;
      tbb::parallel_for(std::size_t{0}, count_, [&, entries](std::size_t k) {
        const double years = k == 0 ? -1.0 : static_cast<double>(k - 1) * ages.years_a_step + remainder;
        entries[k] = of(years, static_cast<double>(rate) / 255.0);
      });
    }
  }

  const T& operator()(std::size_t slot) const {
    const std::int32_t arrival = ages_.arrivals[slot];
    const double age = now_ - arrival;
    const std::size_t index = arrival < 0 || age < 0.0 ? 0 : 1 + static_cast<std::size_t>(age);
    return table_[begin_[ages_.rates.empty() ? 255 : ages_.rates[slot]] + index];
  }

 private:
  const PatinaAges& ages_;
  double now_;  // whole steps
  std::size_t count_ = 0;
  std::array<std::size_t, 256> begin_{};
  std::vector<T> table_;
};

}  // namespace

std::vector<LayerCell> patina_cells(const Material& material, const PatinaAges& ages,
                                    const PatinaGround& ground) {
  const LayerStack looks = looks_of(material);
  const AgeTable<LayerCell> table(ages, [&](double years, double rate) {
    LayerCell cell;
    const std::size_t count = material.layers.size();
    for (std::size_t k = 0; k < count; ++k) {
      const double t = layer_thickness(material.layers[count - 1 - k], ages.exposure, years, rate);
      cell.depth[k] = LayerCell::packed(optical_depth(looks.layers[k], static_cast<float>(t)));
    }
    cell.present = years >= 0.0 && years >= metal_lifetime(material, ages.exposure, rate) ? 0 : 255;
    return cell;
  });
  std::vector<LayerCell> cells(ages.arrivals.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), 8192),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t slot = range.begin(); slot < range.end(); ++slot) {
                        cells[slot] = table(slot);
                        if (!ground.tints.empty()) cells[slot].tint = ground.tints[slot];
                        if (!ground.open.empty()) cells[slot].open = ground.open[slot];
                      }
                    });
  return cells;
}

std::vector<float> patina_heights(const Material& material, const PatinaAges& ages) {
  const AgeTable<float> table(ages, [&](double years, double rate) {
    double height = years < 0.0 ? 0.0 : -metal_loss(material, ages.exposure, years, rate);
    for (const Layer& layer : material.layers)
      height += layer_thickness(layer, ages.exposure, years, rate) - layer.initial;
    return static_cast<float>(height);
  });
  std::vector<float> heights(ages.arrivals.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, heights.size(), 8192),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t slot = range.begin(); slot < range.end(); ++slot)
                        heights[slot] = table(slot);
                    });
  return heights;
}

}  // namespace verdigris
