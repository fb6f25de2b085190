#include "verdigris/material/material.hpp"

#include <algorithm>

namespace verdigris {

double layer_thickness(const Layer& layer, ExposureClass exposure, double years, double factor) {
  const double grown = thickness(layer.growth, exposure, years, factor);
  return layer.shrinks ? std::max(0.0, layer.initial - grown) : layer.initial + grown;
}

double metal_loss(const Material& material, ExposureClass exposure, double years, double factor) {
  return std::min(material.thickness, thickness(material.loss, exposure, years, factor));
}

double metal_lifetime(const Material& material, ExposureClass exposure, double factor) {
  return years_until(material.loss, exposure, material.thickness, factor);
}

Stack stack_at(const Material& material, ExposureClass exposure, double years, double factor) {
  Stack stack{metal_loss(material, exposure, years, factor), {}};
  for (const Layer& layer : material.layers)
    stack.layers.push_back(layer_thickness(layer, exposure, years, factor));
  return stack;
}

}  // namespace verdigris
