#include "sampled_values.hpp"

#include <algorithm>

namespace verdigris::synthesis {

std::vector<float> sampled_values(const ScalarField& field, double cell, std::size_t count) {
  // A walk whose steps no lattice shares (Roberts' sequence of the 4D golden ratio, not wrapped).
  std::vector<double> x(count), y(count), z(count), w(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = cell * static_cast<double>(k);
    x[k] = t * 0.856674883854503;
    y[k] = t * 0.733891856627126;
    z[k] = t * 0.628706721070103;
    w[k] = t * 0.538597257246323;
  }
  std::vector<float> values(count);
  field.evaluate({x, y, z, w}, 0.0, values);
  return values;
}

ValueRange sampled_range(const ScalarField& field, double cell) {
  std::vector<float> values = sampled_values(field, cell, 32768);
  const auto low = values.begin() + 32, high = values.end() - 33;
  std::nth_element(values.begin(), low, values.end());
  const float least = *low;
  std::nth_element(values.begin(), high, values.end());
  const float greatest = *high;
  return {least, greatest > least ? greatest : least + 1.0f, false};
}

}  // namespace verdigris::synthesis
