#pragma once
// What the machine can do, measured in the same run as what is compared with it.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cstring>
#include <vector>

namespace bench {

/// Bytes a second, read and written, of copying arrays far larger than the caches on `threads` threads: the
/// best of a few, measured once for each number of threads.
inline double copy_bandwidth(std::size_t threads) {
  static double known[65] = {};
  if (known[threads] > 0.0) return known[threads];
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  constexpr std::size_t size = std::size_t{256} << 20, piece = std::size_t{1} << 20;
  std::vector<char> from(size, 1), to(size, 2);
  for (int run = 0; run < 5; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    tbb::parallel_for(std::size_t{0}, size / piece,
                      [&](std::size_t k) { std::memcpy(&to[k * piece], &from[k * piece], piece); });
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    benchmark::DoNotOptimize(to.data());
    known[threads] = std::max(known[threads], 2.0 * static_cast<double>(size) / seconds);
  }
  return known[threads];
}

/// Reports cells a second and bytes a cell; with `moved` bytes a cell and step also the share of the copy
/// bandwidth.
inline void report(benchmark::State& state, double cells, double bytes, double moved = 0.0,
                   std::size_t threads = 1) {
  using benchmark::Counter;
  state.counters["cells"] = cells;
  state.counters["cells/s"] = Counter(cells * static_cast<double>(state.iterations()), Counter::kIsRate);
  state.counters["B/cell"] = bytes / cells;
  if (moved > 0.0)
    state.counters["of_copy"] = Counter(
        cells * moved * static_cast<double>(state.iterations()) / copy_bandwidth(threads), Counter::kIsRate);
}

}  // namespace bench
