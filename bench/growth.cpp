// Voronoi growth from 64 seeds until nothing can change.

#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"

namespace {

using namespace verdigris;

// Cells in all; cells a patch; threads.
void sizes(benchmark::internal::Benchmark* b) {
  for (const std::int64_t cells : {100'000, 1'000'000, 10'000'000, 30'000'000}) b->Args({cells, 1000, 1});
  b->Args({1'000'000, 14, 1})
      ->Args({1'000'000, 50'000, 1})
      ->Args({10'000'000, 50'000, 1})
      ->Args({10'000'000, 1000, 2});
  b->Unit(benchmark::kMillisecond)->MinTime(4.0);  // several runs of the largest too
}

void grow(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(2));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const double cells = static_cast<double>(state.range(0));
  const Mesh mesh = bench::sphere(bench::subdivision(cells, static_cast<double>(state.range(1))));
  const Surface s = make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)});
  const auto seeds = random_seeds(s, 64, 7);
  std::size_t bytes = 0;
  for (auto _ : state) {
    VoronoiGrowth growth({s, 7, seeds, {}}, {});
    while (!growth.finished()) growth.step();
    bytes = growth.bytes();
  }
  bench::report_cells(state, static_cast<double>(s.owned_count()), static_cast<double>(s.bytes() + bytes),
                      threads);
}
BENCHMARK(grow)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
