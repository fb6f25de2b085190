// Full sweeps of behaviours that keep a byte a cell.

#include "verdigris/automaton/sweep.hpp"
#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/behaviours/life.hpp"

namespace {

using namespace verdigris;

void life_bytes(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(2));
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const double cells = static_cast<double>(state.range(0));
  const Mesh mesh = bench::sphere(bench::subdivision(cells, static_cast<double>(state.range(1))));
  const Surface s = make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)});
  Field<std::uint8_t> soup(s.slot_count(), 0);
  for (const Row& row : s.rows())
    for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot)
      soup[slot] = CellRandom(1, 0, slot).words(1)[0] < threshold(0.5);
  SweepStepper<LifeBehaviour> stepper(s, {}, std::move(soup), 1);
  for (auto _ : state) benchmark::DoNotOptimize(stepper.step());
  // What a step must move: the state in and out, rows in, source and target of each ghost in.
  const auto slots = static_cast<double>(s.slot_count()), cells_owned = static_cast<double>(s.owned_count()),
             rows = static_cast<double>(sizeof(Row) * s.rows().size()),
             ghosts = static_cast<double>(s.links().size());
  bench::report(state, "cell", cells_owned, static_cast<double>(s.bytes() + stepper.bytes()),
                2.0 * slots + rows + 8.0 * ghosts, threads);
}
BENCHMARK(life_bytes)
    ->ArgsProduct({{100'000, 1'000'000, 10'000'000, 30'000'000}, {1000}, {1}})
    ->Args({30'000'000, 50'000, 1})
    ->Args({10'000'000, 1000, 2})
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
