// Corrosion from 64 new seeds until nothing can change.

#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"

namespace {

using namespace verdigris;

// Cells in all; cells a patch; threads.
void sizes(benchmark::internal::Benchmark* b) {
  for (const std::int64_t cells : {100'000, 1'000'000, 10'000'000, 30'000'000}) b->Args({cells, 1000, 1});
  b->Args({1'000'000, 14, 1})->Args({1'000'000, 50'000, 1})->Args({10'000'000, 1000, 2});
  b->Unit(benchmark::kMillisecond);
}

void corrode(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(2));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const double cells = static_cast<double>(state.range(0));
  const Mesh mesh = bench::sphere(bench::subdivision(cells, static_cast<double>(state.range(1))));
  const Surface s = make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)});
  std::size_t bytes = 0;
  std::uint64_t visited = 0, steps = 0;
  for (auto _ : state) {
    CorrosionGrowth growth({s, 7}, {});
    visited = 0;
    while (!growth.finished()) {
      visited += growth.step().visited;
      bytes = std::max(bytes, growth.bytes());
    }
    steps = growth.steps();
  }
  const auto owned = static_cast<double>(s.owned_count());
  bench::report_cells(state, owned, static_cast<double>(s.bytes() + bytes), threads);
  state.counters["ns/cell"] = benchmark::Counter(owned * static_cast<double>(state.iterations()) * 1e-9,
                                                 benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["visits/cell"] = static_cast<double>(visited) / owned;
  state.counters["steps"] = static_cast<double>(steps);
}
BENCHMARK(corrode)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
