// Building the surface, and refreshing all its ghosts as full sweeps do, on one thread.

#include "verdigris/surface/surface.hpp"
#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/automaton/ghost_carrier.hpp"
#include "verdigris/behaviours/life.hpp"

namespace {

using namespace verdigris;

// Cells in all; cells a patch.
void sizes(benchmark::internal::Benchmark* b) {
  for (const std::int64_t cells : {100'000, 1'000'000, 10'000'000, 30'000'000})
    for (const std::int64_t patch : {14, 1000, 50'000})
      if (cells >= 20 * patch && (patch > 14 || cells < 10'000'000)) b->Args({cells, patch});
  b->Unit(benchmark::kMillisecond);
}

Mesh model(const benchmark::State& state) {
  return bench::sphere(
      bench::subdivision(static_cast<double>(state.range(0)), static_cast<double>(state.range(1))));
}

void build(benchmark::State& state) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Mesh mesh = model(state);
  const double h = cell_size_for(mesh, static_cast<double>(state.range(0)));
  double cells = 0.0, bytes = 0.0;
  for (auto _ : state) {
    const Surface s = make_surface(mesh, {.cell_size = h});
    cells = static_cast<double>(s.owned_count());
    bytes = static_cast<double>(s.bytes());
  }
  bench::report_cells(state, cells, bytes);
}
BENCHMARK(build)->Apply(sizes);

void refresh_ghosts(benchmark::State& state) {
  const Mesh mesh = model(state);
  const Surface s =
      make_surface(mesh, {.cell_size = cell_size_for(mesh, static_cast<double>(state.range(0)))});
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const GhostCarrier<LifeBehaviour> carrier(s);
  const std::vector<std::uint32_t> sources = s.links().sources_of_targets();
  Field<std::uint8_t> field(s.slot_count(), 1);
  for (auto _ : state) {
    carrier.refresh({}, field, sources);
    benchmark::ClobberMemory();
  }
  // Source and target of each, its byte in and out.
  const auto ghosts = static_cast<double>(s.links().size());
  bench::report(state, "ghost", ghosts, 8.0 * ghosts, 10.0 * ghosts);
}
BENCHMARK(refresh_ghosts)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
