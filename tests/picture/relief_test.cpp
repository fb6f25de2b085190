// Surfaces moved by what lies on them: closed ones stay closed, holes have a clean rim, normals follow.
#include "verdigris/picture/relief.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>

#include "verdigris/io/read_mesh.hpp"
#include "verdigris/picture/layers.hpp"
#include "verdigris/picture/normals.hpp"

namespace verdigris {
namespace {

using Bits = std::array<std::uint32_t, 3>;
Bits bits(glm::vec3 p) {
  Bits b;
  std::memcpy(b.data(), &p, sizeof b);
  return b;
}

Surface surface_of(Mesh mesh, double cells) {
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, cells);
  return make_surface(std::move(mesh), options);
}

// A wild relief: every cell on its own, up to three cells high or deep. The low ones are gone.
struct Wild {
  std::vector<float> heights;
  std::vector<LayerCell> cells;

  explicit Wild(const Surface& surface) : heights(surface.slot_count(), 99.0f), cells(surface.slot_count()) {
    const auto size = static_cast<float>(surface.cell_size());
    for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
      for (std::uint32_t s = surface.owned(row).begin; s < surface.owned(row).end; ++s) {
        heights[s] = size * 3.0f * std::sin(static_cast<float>(s) * 12.9898f);
        const glm::dvec3 p = surface.position(s) / (30.0 * surface.cell_size());
        cells[s].present = std::sin(p.x) + std::sin(p.y) + std::sin(p.z) > 0.4 ? 0 : 255;
      }
    surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
      for (const std::uint32_t target : targets) cells[target] = cells[source];
    });
  }
};

struct Edges {
  std::map<std::pair<Bits, Bits>, std::array<int, 2>> uses;  // [from lower end, from higher end]
  std::map<Bits, bool> gone;
  std::size_t dropped = 0, kept = 0;
};

Edges edges_of(const Surface& surface, bool holes) {
  const BandBuilder builder(surface, corner_normals(surface.mesh(), surface.adjacency()),
                            relief_directions(surface.mesh()));
  const Wild wild(surface);
  const Relief relief = ReliefMaker(surface)(wild.heights);
  Edges edges;
  for (const BandRange& range : band_ranges(surface, 5000)) {
    const BandMesh bands = builder.build(range);
    const std::size_t count = bands.positions.size();
    std::vector<glm::vec3> positions(count);
    std::vector<PackedNormal> normals(count);
    std::vector<LayerCell> cells(count);
    std::vector<std::uint8_t> present(count);
    relieve_bands(bands, relief, positions, normals);
    layer_bands(bands, wild.cells, cells);
    for (std::size_t v = 0; v < count; ++v) {
      present[v] = cells[v].present;
      edges.gone[bits(positions[v])] = present[v] < 128;
    }
    std::vector<std::uint32_t> triangles = triangles_of(bands.indices);
    edges.dropped += triangles.size() / 3;
    if (holes) drop_holes(triangles, present);
    edges.dropped -= triangles.size() / 3;
    edges.kept += triangles.size() / 3;
    for (std::size_t t = 0; t < triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const Bits from = bits(positions[triangles[t + k]]), to = bits(positions[triangles[t + (k + 1) % 3]]);
        if (from == to) continue;  // two points that single precision cannot tell apart
        if (from < to)
          ++edges.uses[{from, to}][0];
        else
          ++edges.uses[{to, from}][1];
      }
  }
  return edges;
}

void expect_watertight(const Surface& surface) {
  for (const bool holes : {false, true}) {
    const Edges edges = edges_of(surface, holes);
    std::size_t shared = 0, rims = 0, bad = 0;
    for (const auto& [edge, uses] : edges.uses)
      if (uses == std::array{1, 1})
        ++shared;
      else if (holes && uses[0] + uses[1] == 1 && edges.gone.at(edge.first) && edges.gone.at(edge.second))
        ++rims;
      else
        ++bad;
    EXPECT_EQ(bad, 0u) << (holes ? "with holes" : "whole");
    EXPECT_GT(shared, edges.kept);
    EXPECT_EQ(edges.dropped > 0, holes);
    EXPECT_EQ(rims > 0, holes);
  }
}

TEST(Relief, TheCupStaysWatertight) {
  expect_watertight(surface_of(read_mesh(VERDIGRIS_MESHES "/cup.obj"), 20000.0));
}

TEST(Relief, SpotStaysWatertight) {
  const std::string file = VERDIGRIS_SHARED_MESHES "/spot.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  expect_watertight(surface_of(read_mesh(file), 60000.0));
}

TEST(Relief, EvenHeightMovesEveryFaceOfACubeByIt) {
  Mesh mesh;
  for (unsigned k = 0; k < 8; ++k) mesh.positions.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const Surface surface = surface_of(mesh, 3000.0);
  const BandBuilder builder(surface, corner_normals(mesh, surface.adjacency()), relief_directions(mesh));
  const Relief relief = ReliefMaker(surface)(std::vector<float>(surface.slot_count(), 0.1f));
  const BandMesh bands = builder.build({0, 12});
  std::vector<glm::vec3> positions(bands.positions.size());
  std::vector<PackedNormal> normals(bands.positions.size());
  relieve_bands(bands, relief, positions, normals);
  for (const glm::vec3 p : positions)
    EXPECT_NEAR(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 0.6f, 1e-5f);
  for (std::size_t v = 0; v < normals.size(); ++v)
    EXPECT_LT(glm::distance(unpack_normal(normals[v]), unpack_normal(bands.normals[v])), 1e-4f);
}

// A wave on a sheet of irregular triangles: normals are those of the wave, and the same on both sides of an
// edge.
TEST(Relief, NormalsFollowTheReliefAcrossEdges) {
  const Surface surface = surface_of(read_mesh(VERDIGRIS_MESHES "/sheet.obj"), 250000.0);
  const Mesh& mesh = surface.mesh();
  const Bounds bounds = mesh_bounds(mesh);
  const glm::dvec3 normal = surface.frame(0).normal();
  const glm::dvec3 along = glm::normalize(surface.frame(0).u);
  const auto wave = [&](glm::dvec3 p) { return 0.02 * std::sin(20.0 * glm::dot(p, along)); };
  std::vector<float> heights(surface.slot_count(), 0.0f);
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t s = surface.owned(row).begin; s < surface.owned(row).end; ++s)
      heights[s] = static_cast<float>(wave(surface.position(s)));
  const Relief relief = ReliefMaker(surface)(heights);
  const BandBuilder builder(surface, corner_normals(mesh, surface.adjacency()), relief_directions(mesh));
  std::map<Bits, PackedNormal> seen;
  std::size_t off = 0, all = 0;
  for (const BandRange& range : band_ranges(surface)) {
    const BandMesh bands = builder.build(range);
    std::vector<glm::vec3> positions(bands.positions.size());
    std::vector<PackedNormal> normals(bands.positions.size());
    relieve_bands(bands, relief, positions, normals);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const glm::dvec3 p = glm::dvec3(bands.positions[v]) + builder.origin();
      const glm::dvec3 from = p - bounds.lower, to = bounds.upper - p;
      double margin = 1.0;  // of the open sheet's own border, where slopes are one-sided
      for (int k = 0; k < 3; ++k)
        if (bounds.upper[k] - bounds.lower[k] > 0.5) margin = std::min({margin, from[k], to[k]});
      if (margin < 3.0 * surface.cell_size()) continue;
      const glm::dvec3 expected = glm::normalize(normal - 0.4 * std::cos(20.0 * glm::dot(p, along)) * along);
      off += glm::distance(expected, glm::dvec3(unpack_normal(normals[v]))) > 0.03;
      ++all;
      const auto [entry, fresh] = seen.emplace(bits(positions[v]), normals[v]);
      ASSERT_TRUE(fresh || entry->second == normals[v]);
    }
  }
  // A few cells in the tips of triangles see too little around them.
  EXPECT_LT(off * 5000, all);
}

}  // namespace
}  // namespace verdigris
