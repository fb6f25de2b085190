// The same partition three ways: growth over cells, multi-source Dijkstra over vertices, CGAL's heat method.

#include <queue>

#include "../machine.hpp"
#include "../sphere.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"
#ifdef VERDIGRIS_WITH_CGAL
#include "heat.hpp"
#endif

namespace {

using namespace verdigris;

constexpr std::size_t seed_count = 64;

// Vertices spread over the whole index range: the same for all methods on one mesh.
std::vector<std::uint32_t> seed_vertices(const Mesh& mesh) {
  std::vector<std::uint32_t> seeds;
  for (std::size_t k = 0; k < seed_count; ++k)
    seeds.push_back(CellRandom(7, 0, static_cast<std::uint32_t>(k)).words(1)[0] %
                    static_cast<std::uint32_t>(mesh.positions.size()));
  return seeds;
}

// Share of vertices or cells whose label is not that of the nearest seed along the great circle.
template <typename At>
double mislabelled(const std::vector<glm::dvec3>& seeds, std::size_t count, At&& at) {
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto [p, label] = at(k);
    std::size_t nearest = 0;
    for (std::size_t s = 1; s < seeds.size(); ++s)
      if (glm::dot(p, seeds[s]) > glm::dot(p, seeds[nearest])) nearest = s;
    wrong += static_cast<std::size_t>(label) != nearest;
  }
  return static_cast<double>(wrong) / static_cast<double>(count);
}

std::vector<glm::dvec3> positions(const Mesh& mesh, const std::vector<std::uint32_t>& seeds) {
  std::vector<glm::dvec3> points;
  for (const std::uint32_t v : seeds) points.push_back(mesh.positions[v]);
  return points;
}

void growth(benchmark::State& state) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const double cells = static_cast<double>(state.range(0));
  const Mesh mesh = bench::sphere(bench::subdivision(cells, static_cast<double>(state.range(1))));
  const Surface s = make_surface(mesh, {.cell_size = cell_size_for(mesh, cells)});
  std::vector<Seed> seeds;
  std::vector<glm::dvec3> points;
  for (const Seed& seed : random_seeds(s, seed_count, 7)) {
    seeds.push_back(seed);
    points.push_back(glm::normalize(s.position(seed.slot)));
  }
  Field<std::int32_t> labels;
  for (auto _ : state) {
    VoronoiGrowth grow({s, 7, seeds, {}}, {});
    while (!grow.finished()) grow.step();
    state.PauseTiming();
    labels = grow.labels();
    state.ResumeTiming();
  }
  std::vector<std::uint32_t> slots;
  for (std::uint32_t r = 0; r < s.rows().size(); ++r)
    for (std::uint32_t slot = s.owned(r).begin; slot < s.owned(r).end; slot += 16) slots.push_back(slot);
  state.counters["cells"] = static_cast<double>(s.owned_count());
  state.counters["mislabelled"] = mislabelled(points, slots.size(), [&](std::size_t k) {
    return std::pair{glm::normalize(s.position(slots[k])), labels[slots[k]]};
  });
}
BENCHMARK(growth)->Args({1'000'000, 1000})->Args({1'000'000, 50'000})->Unit(benchmark::kMillisecond);

// Neighbours in one array, a heap of (distance, vertex), stale entries skipped: what one would write with
// care.
void dijkstra(benchmark::State& state) {
  const Mesh mesh = bench::sphere(static_cast<int>(state.range(0)));
  const std::size_t n = mesh.positions.size();
  std::vector<std::uint32_t> begin(n + 1, 0), to(3 * mesh.triangles.size());
  std::vector<float> length(to.size());
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++begin[t[k] + 1];
  for (std::size_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
  auto at = begin;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];  // the other direction comes with the other triangle
      to[at[a]] = b;
      length[at[a]++] = static_cast<float>(glm::length(mesh.positions[a] - mesh.positions[b]));
    }
  const auto seeds = seed_vertices(mesh);
  std::vector<float> distance;
  std::vector<std::int32_t> label;
  for (auto _ : state) {
    distance.assign(n, 1e30f);
    label.assign(n, -1);
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
    for (std::size_t k = 0; k < seeds.size(); ++k) {
      distance[seeds[k]] = 0.0f;
      label[seeds[k]] = static_cast<std::int32_t>(k);
      heap.emplace(0.0f, seeds[k]);
    }
    while (!heap.empty()) {
      const auto [d, v] = heap.top();
      heap.pop();
      if (d > distance[v]) continue;
      for (std::uint32_t e = begin[v]; e < begin[v + 1]; ++e)
        if (const float other = d + length[e]; other < distance[to[e]]) {
          distance[to[e]] = other;
          label[to[e]] = label[v];
          heap.emplace(other, to[e]);
        }
    }
  }
  state.counters["vertices"] = static_cast<double>(n);
  state.counters["mislabelled"] = mislabelled(positions(mesh, seeds), n / 16, [&](std::size_t k) {
    return std::pair{mesh.positions[16 * k], label[16 * k]};
  });
}
BENCHMARK(dijkstra)->Arg(316)->Unit(benchmark::kMillisecond);  // 998,562 vertices

#ifdef VERDIGRIS_WITH_CGAL
void heat_method(benchmark::State& state) {
  const Mesh mesh = bench::sphere(static_cast<int>(state.range(0)));
  const auto seeds = seed_vertices(mesh);
  bench::HeatTimes times;
  for (auto _ : state) times = bench::heat_partition(mesh, seeds);
  state.counters["vertices"] = static_cast<double>(mesh.positions.size());
  state.counters["factor_s"] = times.factor;
  state.counters["solves_s"] = times.solves;
  state.counters["mislabelled"] =
      mislabelled(positions(mesh, seeds), mesh.positions.size() / 16, [&](std::size_t k) {
        return std::pair{mesh.positions[16 * k], times.labels[16 * k]};
      });
}
// 25,002, 249,642 and 998,562 vertices; the last takes minutes and 3 GB.
BENCHMARK(heat_method)->Arg(50)->Arg(158)->Arg(316)->Iterations(1)->Unit(benchmark::kMillisecond);
#endif

}  // namespace

BENCHMARK_MAIN();
