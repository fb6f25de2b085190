#pragma once
// How a layer or a loss of metal grows with time: closed forms of age, in real units.

#include <array>
#include <cstdint>
#include <string_view>

namespace verdigris {

/// Corrosivity of an atmosphere, ISO 9223: very low, low, medium, high, very high, extreme.
enum class ExposureClass : std::uint8_t { C1, C2, C3, C4, C5, CX };
inline constexpr std::array<std::string_view, 6> exposure_class_names{"C1", "C2", "C3", "C4", "C5", "CX"};

/// InputError unless `name` is one of exposure_class_names.
ExposureClass exposure_class_named(std::string_view name);

/// A number for each exposure class.
using PerClass = std::array<double, 6>;

enum class GrowthKind : std::uint8_t {
  linear,     ///< D = r t: the k1 and k2 of Gobron & Chiba 1999, Appendix 1
  parabolic,  ///< D = r sqrt(t): growth limited by diffusion through the layer itself (Wagner)
  power,      ///< D = r t^b: atmospheric corrosion, ISO 9224
};

/// D(t), micrometres, for t years since the onset; the onset is `delay` years after the cell corroded. Rates
/// are what grows in the first year. After `steady_after` years a power law goes on at the speed it has then
/// (ISO 9224: 20 years). D never exceeds `saturation` (the k3 of the paper).
struct GrowthLaw {
  GrowthKind kind = GrowthKind::linear;
  PerClass rate{};                                    ///< micrometres in the first year, >= 0
  double exponent = 1.0;                              ///< b of a power law, 0..1
  PerClass delay{};                                   ///< years, >= 0
  PerClass saturation{1e9, 1e9, 1e9, 1e9, 1e9, 1e9};  ///< micrometres
  double steady_after = 1e9;                          ///< years
};

/// D at `years` since the cell corroded; 0 before the onset. `factor` multiplies the rate, not the bounds.
double thickness(const GrowthLaw& law, ExposureClass exposure, double years, double factor = 1.0);

/// Years at which D reaches `micrometres`; infinite when it never does.
double years_until(const GrowthLaw& law, ExposureClass exposure, double micrometres, double factor = 1.0);

}  // namespace verdigris
