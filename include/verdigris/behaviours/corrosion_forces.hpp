#pragma once
// How strong attack and defence are when corrosion spreads (Gobron & Chiba 1999, Fig. 19).

#include <algorithm>
#include <cstdint>

namespace verdigris {

/// What attack and defence are made of: pure numbers that are compared with each other. The defaults were
/// tuned for round spots and for a speed of about a ninth of Voronoi growth, which is what the paper reports.
struct CorrosionForces {
  double attack = 1.0;           ///< greatest force
  double luck = 0.5;             ///< random share of the force
  std::uint32_t attack_age = 8;  ///< steps, at least 1
  std::uint32_t reach_age = 24;  ///< steps, at least 1
  double defence = 0.7, strong_defence = 0.85, support = 0.01;

  double force(std::uint64_t age) const {
    return attack * (static_cast<double>(std::min<std::uint64_t>(age, attack_age)) / attack_age);
  }
  /// Least age at which an attack can overcome the weakest; never: the greatest number.
  std::uint64_t ripe_age() const {
    const double least = std::min(defence, strong_defence);
    if (attack <= least) return ~std::uint64_t{0};
    auto age = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(least / attack * attack_age));
    while (age > 1 && force(age - 1) > least) --age;
    while (force(age) <= least) ++age;
    return age;
  }
};

}  // namespace verdigris
