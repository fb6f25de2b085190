#pragma once
// How thick metal and oxide of a corroded cell are: Gobron & Chiba 1999, Appendix 1, as closed forms of age.

#include <algorithm>
#include <cstdint>

namespace verdigris {

/// In each step a corroded cell loses k1 of its metal and gains k2 of oxide, up to k3; with no metal left it
/// does not exist any more. (The paper prints ot - k2; with its clamp at k3 it can only be a growth.) `age`
/// is in steps since the cell corroded, `rate` multiplies k1 and k2 in the cell.
struct LinearThickness {
  double metal = 1000.0;  ///< micrometres, of a sound cell
  double k1 = 0.02;       ///< micrometres of metal lost a step
  double k2 = 0.033;      ///< micrometres of oxide gained a step
  double k3 = 20.0;       ///< micrometres, the thickest oxide

  /// First age at which no metal is left; the greatest number when that is never.
  std::uint64_t lifetime(double rate = 1.0) const {
    const double loss = k1 * rate, never = 1e18;
    if (!(metal > 0.0)) return 0;
    if (!(loss * never > metal)) return ~std::uint64_t{0};
    auto age = static_cast<std::uint64_t>(metal / loss);
    while (metal - loss * static_cast<double>(age) > 0.0) ++age;
    while (age > 0 && metal - loss * static_cast<double>(age - 1) <= 0.0) --age;
    return age;
  }
  bool exists(std::uint64_t age, double rate = 1.0) const { return age < lifetime(rate); }
  double depth(std::uint64_t age, double rate = 1.0) const {
    return std::min(metal, k1 * rate * static_cast<double>(age));
  }
  double metal_left(std::uint64_t age, double rate = 1.0) const { return metal - depth(age, rate); }
  /// Of a cell that does not exist any more: what it had at its end.
  double oxide(std::uint64_t age, double rate = 1.0) const {
    return std::min(k3, k2 * rate * static_cast<double>(std::min(age, lifetime(rate))));
  }
};

}  // namespace verdigris
