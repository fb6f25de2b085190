#include "verdigris/material/growth_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "verdigris/base/error.hpp"

namespace verdigris {

ExposureClass exposure_class_named(std::string_view name) {
  for (std::size_t k = 0; k < exposure_class_names.size(); ++k)
    if (exposure_class_names[k] == name) return static_cast<ExposureClass>(k);
  throw InputError("exposure class", "there is none named '" + std::string(name) + "'",
                   "choose C1, C2, C3, C4, C5 or CX (ISO 9223)");
}

namespace {

double exponent_of(const GrowthLaw& law) {
  return law.kind == GrowthKind::linear ? 1.0 : law.kind == GrowthKind::parabolic ? 0.5 : law.exponent;
}

}  // namespace

double thickness(const GrowthLaw& law, ExposureClass exposure, double years, double factor) {
  const auto k = static_cast<std::size_t>(exposure);
  const double t = years - law.delay[k];
  if (!(t > 0.0)) return 0.0;
  const double rate = law.rate[k] * factor, b = exponent_of(law), bend = law.steady_after;
  const double grown = t <= bend ? rate * std::pow(t, b)
                                 : rate * (std::pow(bend, b) + b * std::pow(bend, b - 1.0) * (t - bend));
  return std::min(grown, law.saturation[k]);
}

double years_until(const GrowthLaw& law, ExposureClass exposure, double micrometres, double factor) {
  const auto k = static_cast<std::size_t>(exposure);
  if (micrometres <= 0.0) return 0.0;
  const double rate = law.rate[k] * factor, b = exponent_of(law), bend = law.steady_after;
  if (!(rate > 0.0) || micrometres > law.saturation[k]) return std::numeric_limits<double>::infinity();
  const double parts = micrometres / rate, at_bend = std::pow(bend, b);
  const double t =
      parts <= at_bend ? std::pow(parts, 1.0 / b) : bend + (parts - at_bend) / (b * std::pow(bend, b - 1.0));
  return law.delay[k] + t;
}

}  // namespace verdigris
