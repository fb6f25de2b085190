#pragma once
// The points that scalar fields are measured at.

#include <benchmark/benchmark.h>

#include <vector>

#include "verdigris/synthesis/scalar_field.hpp"

namespace bench {

/// A section of 512 x 512 points through the unit cube.
struct Section {
  static constexpr std::size_t side = 512;
  std::vector<double> x, y, z;

  Section() {
    for (std::size_t k = 0; k < side * side; ++k) {
      x.push_back(static_cast<double>(k % side) / side);
      y.push_back(static_cast<double>(k / side) / side);
      z.push_back(0.3);
    }
  }
  std::size_t size() const { return x.size(); }
};

inline void report_samples(benchmark::State& state, std::size_t each) {
  state.counters["Msamples/s"] =
      benchmark::Counter(1e-6 * static_cast<double>(each) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate);
}

/// Values of `field` all over the section, on this thread.
inline void sample(benchmark::State& state, const verdigris::ScalarField& field) {
  const Section section;
  std::vector<float> out(section.size());
  for (auto _ : state) {
    field.evaluate({section.x, section.y, section.z}, 0.0, out);
    benchmark::DoNotOptimize(out.data());
  }
  report_samples(state, section.size());
}

}  // namespace bench
