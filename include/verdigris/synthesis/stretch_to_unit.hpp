#pragma once
// Values of any range brought to 0 .. 1, as pictures and masks need them.

#include <span>

namespace verdigris {

/// 0 where a value is `low` or less, 1 where it is `high` or more, in proportion between; low may be the
/// greater one. Throws std::invalid_argument when they are equal, or too far out or too close for a float.
void stretch_to_unit(std::span<float> values, double low, double high);

}  // namespace verdigris
