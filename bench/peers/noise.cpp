// Six octaves in 3D on one thread, beside libnoise where it is installed (Debian: libnoise-dev).

#include "../samples.hpp"
#include "verdigris/synthesis/multifractals.hpp"
#ifdef VERDIGRIS_WITH_LIBNOISE
#include <libnoise/noise.h>
#endif

namespace {

using namespace verdigris;

void fbm(benchmark::State& state) {
  bench::sample(state, *Fbm{{.frequency = 4.0}, {.octaves = 6, .lacunarity = 2.0, .H = 1.0}}.make(1));
}
BENCHMARK(fbm)->Unit(benchmark::kMillisecond);

void ridged(benchmark::State& state) {
  bench::sample(state,
                *RidgedMultifractal{{.frequency = 4.0}, {.octaves = 6, .lacunarity = 2.0, .H = 1.0}}.make(1));
}
BENCHMARK(ridged)->Unit(benchmark::kMillisecond);

#ifdef VERDIGRIS_WITH_LIBNOISE
template <typename Module>
void peer(benchmark::State& state) {
  Module module;
  module.SetFrequency(4.0);
  module.SetLacunarity(2.0);
  module.SetOctaveCount(6);
  const bench::Section section;
  std::vector<float> out(section.size());
  for (auto _ : state) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = static_cast<float>(module.GetValue(section.x[k], section.y[k], section.z[k]));
    benchmark::DoNotOptimize(out.data());
  }
  bench::report_samples(state, out.size());
}
BENCHMARK(peer<noise::module::Perlin>)->Name("libnoise_fbm")->Unit(benchmark::kMillisecond);
BENCHMARK(peer<noise::module::RidgedMulti>)->Name("libnoise_ridged")->Unit(benchmark::kMillisecond);
#endif

}  // namespace

BENCHMARK_MAIN();
