#pragma once
// What the machine can do, measured in the same run as what is compared with it.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <cstring>
#include <string>
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

/// Reports things a second, how many bytes each takes, and which share of the copy bandwidth an iteration
/// reaches that must move `moved` bytes.
inline void report(benchmark::State& state, const char* things, double count, double bytes, double moved,
                   std::size_t threads = 1) {
  using benchmark::Counter;
  const auto iterations = static_cast<double>(state.iterations());
  const std::string name = things;
  state.counters[name + "s"] = count;
  state.counters[name + "s/s"] = Counter(count * iterations, Counter::kIsRate);
  state.counters["B/" + name] = bytes / count;
  state.counters["of_copy"] = Counter(moved * iterations / copy_bandwidth(threads), Counter::kIsRate);
}
/// The same for cells; what they take is moved once.
inline void report_cells(benchmark::State& state, double cells, double bytes, std::size_t threads = 1) {
  report(state, "cell", cells, bytes, bytes, threads);
}

}  // namespace bench
