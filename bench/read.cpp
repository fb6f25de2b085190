// Reading a model: triangles a second by format, written first to a directory of its own.

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "machine.hpp"
#include "sphere.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/mesh/adjacency.hpp"

namespace {

std::filesystem::path write_obj(int n) {
  const auto file =
      std::filesystem::temp_directory_path() / fmt::format("verdigris-bench-{}-{}.obj", ::getpid(), n);
  const verdigris::Mesh mesh = bench::sphere(n);
  std::ofstream out(file);
  for (const auto& p : mesh.positions) out << fmt::format("v {:.9g} {:.9g} {:.9g}\n", p.x, p.y, p.z);
  for (const auto& t : mesh.triangles) out << fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  return file;
}

void read_obj(benchmark::State& state) {
  const auto file = write_obj(static_cast<int>(state.range(0)));
  std::size_t triangles = 0;
  for (auto _ : state) triangles = verdigris::read_mesh(file).triangles.size();
  const auto bytes = static_cast<double>(std::filesystem::file_size(file));
  bench::report(state, "triangle", static_cast<double>(triangles), bytes, bytes);
  std::filesystem::remove(file);
}
// Of 98,000, a million and ten million triangles.
BENCHMARK(read_obj)->Arg(70)->Arg(224)->Arg(707)->Unit(benchmark::kMillisecond);

void adjacency(benchmark::State& state) {
  const verdigris::Mesh mesh = bench::sphere(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(verdigris::make_adjacency(mesh));
  const double bytes = 12.0 * static_cast<double>(mesh.triangles.size());  // the corners, once
  bench::report(state, "triangle", static_cast<double>(mesh.triangles.size()), bytes, bytes);
}
BENCHMARK(adjacency)->Arg(70)->Arg(224)->Arg(707)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
