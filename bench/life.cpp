// Life-like rules on packed cells: a half-full soup on flat tori of about 16M cells and on spheres.

#include <algorithm>
#include <cstring>
#include <vector>

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
  // What a step must move: the state in and out, groups and numbers in, what is sent in and out.
  const double cells = static_cast<double>(packed.owned_count()),
               bytes = static_cast<double>(packed.bytes() + life.bytes());
  const auto state_bytes = static_cast<double>(8 * life.state().size());
  bench::report(state, "cell", cells, bytes, bytes + state_bytes, threads);
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

// A plain bit-sliced step on a flat grid of 4096 x 4096, Life only: what the surface is measured against.
// Rows of 64 words, a word more at both ends and a row more below and above for the wrap.
void flat(benchmark::State& state) {
  typedef std::uint64_t Words __attribute__((vector_size(64)));  // NOLINT(modernize-use-using)
  constexpr std::size_t side = 4096, words = side / 64, pitch = words + 16;
  std::vector<std::uint64_t> now((side + 2) * pitch, 0), next(now.size(), 0);
  for (std::size_t k = 0; k < now.size(); ++k)
    for (std::uint32_t b = 0; b < 16; ++b)
      for (const std::uint32_t word : CellRandom(1, 0, static_cast<std::uint32_t>(k)).words(1, b))
        now[k] = now[k] << 4 | (word >> 28);
  const auto load = [](const std::uint64_t* from, Words& to) { std::memcpy(&to, from, sizeof to); };
  const auto wrap = [&](std::vector<std::uint64_t>& cells) {
    std::copy_n(cells.begin() + side * pitch, pitch, cells.begin());
    std::copy_n(cells.begin() + pitch, pitch, cells.begin() + (side + 1) * pitch);
    for (std::size_t y = 0; y < side + 2; ++y) {
      cells[y * pitch + 7] = cells[y * pitch + 7 + words];
      cells[y * pitch + 8 + words] = cells[y * pitch + 8];
    }
  };
  for (auto _ : state) {
    wrap(now);
    for (std::size_t x = 8; x < 8 + words; x += 8) {
      Words ones[3], twos[3], centre[3];
      const auto add_row = [&](std::size_t y, std::size_t k) {
        Words left, right;
        load(&now[y * pitch + x], centre[k]);
        load(&now[y * pitch + x - 1], left);
        load(&now[y * pitch + x + 1], right);
        const Words a = centre[k] << 1 | left >> 63, b = centre[k] >> 1 | right << 63;
        ones[k] = a ^ b ^ centre[k];
        twos[k] = (a & b) | (centre[k] & (a ^ b));
      };
      add_row(0, 0);
      add_row(1, 1);
      for (std::size_t y = 1; y <= side; ++y) {
        const std::size_t below = (y - 1) % 3, here = y % 3, above = (y + 1) % 3;
        add_row(y + 1, above);
        // The sum of all nine: 3 lives, 4 stays as it is.
        const Words o = ones[below] ^ ones[here] ^ ones[above],
                    oc = (ones[below] & ones[here]) | (ones[above] & (ones[below] ^ ones[here])),
                    t = twos[below] ^ twos[here] ^ twos[above],
                    tc = (twos[below] & twos[here]) | (twos[above] & (twos[below] ^ twos[here]));
        const Words two = t ^ oc, carry = t & oc, four = tc ^ carry, eight = tc & carry;
        const Words born = o & two & ~four & ~eight, stays = ~o & ~two & four & ~eight & centre[here];
        const Words alive = born | stays;
        std::memcpy(&next[y * pitch + x], &alive, sizeof alive);
      }
    }
    now.swap(next);
    benchmark::DoNotOptimize(now.data());
  }
  bench::report_cells(state, static_cast<double>(side * side), 16.0 * static_cast<double>(now.size()));
  state.SetLabel("Life, no surface");
}
BENCHMARK(flat)->Unit(benchmark::kMillisecond);

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
