// Life-like rules on packed cells: a half-full soup on flat tori of about 16M cells and on spheres.

#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/behaviours/packed_life.hpp"
#include "verdigris/surface/flat_torus.hpp"

namespace {

using namespace verdigris;

const char* const rules[] = {"Life", "Coagulations", "Amoeba"};

void run(benchmark::State& state, const PackedSurface& packed, const char* rule, std::size_t threads) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  PackedLife life(packed, parse_life_rule(rule));
  life.fill(0.5, 1);
  for (auto _ : state) benchmark::DoNotOptimize(life.step());
  // What a step must move: the state in and out, masks and ghost sources in.
  const double cells = static_cast<double>(packed.owned_count()),
               bytes = static_cast<double>(packed.bytes() + life.bytes());
  bench::report(state, cells, bytes, static_cast<double>(packed.bytes() + 2 * life.bytes()) / cells, threads);
  state.SetLabel(rule);
}

void torus(benchmark::State& state) {
  const auto patch = static_cast<std::uint32_t>(state.range(0));
  const std::uint32_t side = 4096 / patch * patch;
  const PackedSurface packed(make_flat_torus(side, side, patch));
  run(state, packed, rules[state.range(1)], static_cast<std::size_t>(state.range(2)));
}
// Patches of 961, 50,176 and 1,048,576 cells.
BENCHMARK(torus)
    ->ArgsProduct({{62, 448, 2048}, {0, 1, 2}, {1}})
    ->Args({448, 0, 2})
    ->Unit(benchmark::kMillisecond);

void sphere(benchmark::State& state) {
  const double cells = static_cast<double>(state.range(0));
  const Mesh mesh = bench::sphere(bench::subdivision(cells, static_cast<double>(state.range(1))));
  const PackedSurface packed(make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)}));
  run(state, packed, "Life", static_cast<std::size_t>(state.range(2)));
}
BENCHMARK(sphere)
    ->ArgsProduct({{100'000, 1'000'000, 10'000'000, 30'000'000}, {1000}, {1}})
    ->Args({30'000'000, 50'000, 1})
    ->Args({10'000'000, 1000, 2})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
