// Bands, and drawing them off screen at 1280 x 960.

#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/gl/renderer.hpp"
#include "verdigris/picture/normals.hpp"

namespace {

using namespace verdigris;

Surface model(double cells) {
  const Mesh mesh = bench::sphere(bench::subdivision(cells, 1000));
  return make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)});
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const std::int64_t cells : {100'000, 1'000'000, 10'000'000, 30'000'000}) b->Arg(cells);
  b->Unit(benchmark::kMillisecond);
}

void bands(benchmark::State& state) {
  const Surface s = model(static_cast<double>(state.range(0)));
  const BandBuilder builder(s, corner_normals(s.mesh(), s.adjacency()));
  std::size_t bytes = 0;
  for (auto _ : state) {
    bytes = 0;
    for (const BandRange& range : band_ranges(s)) bytes += builder.build(range).bytes();
  }
  bench::report_cells(state, static_cast<double>(s.owned_count()), static_cast<double>(bytes));
}
BENCHMARK(bands)->Apply(sizes);

void picture(benchmark::State& state) {
  const Surface s = model(static_cast<double>(state.range(0)));
  const std::vector<Rgba8> colours(s.slot_count(), Rgba8{184, 115, 51, 255});
  const Camera camera = frame_mesh(s.mesh(), "iso");
  RenderOptions options;
  options.cache_bytes = 0;
  for (auto _ : state) benchmark::DoNotOptimize(render(s, colours, camera, options));
  bench::report_cells(state, static_cast<double>(s.owned_count()),
                      static_cast<double>(s.bytes() + 4 * s.slot_count()));
}
BENCHMARK(picture)->Apply(sizes);

}  // namespace

BENCHMARK_MAIN();
