// Bands of whole surfaces: exact area, no cracks, values that agree on both sides of every edge.
#include "verdigris/picture/bands.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <glm/geometric.hpp>
#include <map>

#include "verdigris/io/read_mesh.hpp"
#include "verdigris/picture/normals.hpp"

namespace verdigris {
namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {0.3, 0.3, 0.9}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

Mesh cube() {
  Mesh mesh;
  for (unsigned k = 0; k < 8; ++k) mesh.positions.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Surface surface_of(Mesh mesh, double cells, LinkKind links = LinkKind::unfolded) {
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, cells);
  options.links = links;
  return make_surface(std::move(mesh), options);
}

BandBuilder builder_of(const Surface& surface) {
  return {surface, corner_normals(surface.mesh(), surface.adjacency())};
}

using Bits = std::array<std::uint32_t, 3>;
Bits bits(glm::vec3 p) {
  Bits b;
  std::memcpy(b.data(), &p, sizeof b);
  return b;
}

struct Totals {
  double area = 0.0, signed_volume = 0.0;
  std::size_t unmatched = 0, triangles = 0;
};

// Directed edges by the bits of their ends: in a closed surface each has its opposite exactly as often as
// itself.
Totals totals(const BandBuilder& builder, std::size_t slots) {
  Totals result;
  std::map<std::pair<Bits, Bits>, int> edges;
  for (const BandRange& range : band_ranges(builder.surface(), slots)) {
    const BandMesh bands = builder.build(range);
    const std::vector<std::uint32_t> triangles = triangles_of(bands.indices);
    result.triangles += triangles.size() / 3;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      std::array<glm::vec3, 3> p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = bands.positions[triangles[t + k]];
      const glm::dvec3 a = p[0], b = p[1], c = p[2];
      result.area += 0.5 * glm::length(glm::cross(b - a, c - a));
      result.signed_volume += glm::dot(a, glm::cross(b, c)) / 6.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const Bits from = bits(p[k]), to = bits(p[(k + 1) % 3]);
        if (from == to) continue;  // two points that single precision cannot tell apart
        if (from < to)
          ++edges[{from, to}];
        else
          --edges[{to, from}];
      }
    }
  }
  for (const auto& [edge, balance] : edges) result.unmatched += balance != 0;
  return result;
}

TEST(Bands, ClosedMeshesStayClosed) {
  for (const double cells : {3.0, 40.0, 1000.0, 20000.0})
    for (const LinkKind links : {LinkKind::unfolded, LinkKind::projected})
      for (const Mesh& mesh : {tetrahedron(), cube()}) {
        const Surface surface = surface_of(mesh, cells, links);
        const BandBuilder builder = builder_of(surface);
        const Totals whole = totals(builder, 1u << 20), cut = totals(builder, 64);
        EXPECT_EQ(whole.unmatched, 0u) << cells;
        EXPECT_EQ(cut.unmatched, 0u) << cells;
        EXPECT_EQ(whole.triangles, cut.triangles);
        EXPECT_NEAR(whole.area / mesh_area(mesh), 1.0, 1e-5);
        EXPECT_GT(whole.signed_volume, 0.1);
      }
}

TEST(Bands, RealModelsStayClosedAndKeepTheirArea) {
  for (const char* name : {"spot", "fandisk"}) {
    const std::string file = std::string(VERDIGRIS_SHARED_MESHES "/") + name + ".obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    for (const double cells : {500.0, 100000.0}) {
      const Surface surface = surface_of(read_mesh(file), cells);
      const Totals sum = totals(builder_of(surface), 1u << 14);
      EXPECT_EQ(sum.unmatched, 0u) << name << ", " << cells << " cells";
      EXPECT_NEAR(sum.area / mesh_area(surface.mesh()), 1.0, 1e-5);
    }
  }
}

TEST(Bands, EveryVertexIsInOneRunAndWeightsSumToOne) {
  const Surface surface = surface_of(cube(), 3000.0);
  const BandBuilder builder = builder_of(surface);
  for (const BandRange& range : band_ranges(surface, 500)) {
    const BandMesh bands = builder.build(range);
    std::vector<int> seen(bands.positions.size(), 0);
    for (const CentreRun& run : bands.centres)
      for (std::uint32_t k = 0; k < run.count; ++k) {
        ++seen[run.vertex + k];
        ASSERT_TRUE(surface.is_owned(run.slot + k));
        const glm::dvec3 p = glm::dvec3(bands.positions[run.vertex + k]) + builder.origin();
        ASSERT_LT(glm::distance(p, surface.position(run.slot + k)), 1e-6);
      }
    for (const ContourRun& run : bands.contours)
      for (std::uint32_t k = 0; k < run.count; ++k) {
        ++seen[run.vertex + k];
        float sum = 0.0f;
        for (std::uint32_t n = bands.blend_begin[run.blend + k]; n < bands.blend_begin[run.blend + k + 1];
             ++n)
          sum += bands.blends[n].weight;
        ASSERT_NEAR(sum, 1.0f, 1e-5f);
      }
    for (const int times : seen) ASSERT_EQ(times, 1);
  }
}

// Colours that follow the position in space: where two triangles meet they must agree to the bit.
TEST(Bands, BothSidesOfAnEdgeGetOneColour) {
  const Surface surface = surface_of(tetrahedron(), 5000.0);
  const BandBuilder builder = builder_of(surface);
  std::vector<Rgba8> colours(surface.slot_count(), {255, 0, 255, 255});  // what no vertex may show
  const auto colour_of = [&](std::uint32_t slot) {
    const glm::dvec3 p = surface.position(slot);
    return Rgba8{static_cast<std::uint8_t>(100 + 100 * std::sin(9 * p.x)),
                 static_cast<std::uint8_t>(120 + 100 * std::sin(11 * p.y)), 90, 255};
  };
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t s = surface.owned(row).begin; s < surface.owned(row).end; ++s)
      colours[s] = colour_of(s);
  surface.links().for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) colours[target] = colours[source];
  });
  std::map<Bits, Rgba8> at;
  for (const BandRange& range : band_ranges(surface)) {
    const BandMesh bands = builder.build(range);
    std::vector<Rgba8> out(bands.positions.size());
    colour_bands(bands, colours, out);
    for (std::size_t v = 0; v < out.size(); ++v) {
      ASSERT_LE(out[v].b, 92);
      const auto [entry, fresh] = at.emplace(bits(bands.positions[v]), out[v]);
      ASSERT_TRUE(fresh || entry->second == out[v]);
    }
  }
}

TEST(Bands, OpenEdgesTakeNothingFromEmptySlots) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0, 0}, {1, 2, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Surface surface = surface_of(mesh, 500.0);
  std::vector<Rgba8> colours(surface.slot_count(), {255, 0, 0, 255});
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t s = surface.owned(row).begin; s < surface.owned(row).end; ++s)
      colours[s] = {0, 80, 0, 255};
  const BandMesh bands = builder_of(surface).build({0, 1});
  std::vector<Rgba8> out(bands.positions.size());
  colour_bands(bands, colours, out);
  for (const Rgba8 c : out) ASSERT_EQ(c, (Rgba8{0, 80, 0, 255}));
}

TEST(Bands, TrianglesOfNoAreaAndWithoutCellsAreNoTrouble) {
  Mesh mesh;  // a strip of which one triangle is flat and another far smaller than a cell
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {2, 3, 0}, {4, 1e-3, 0}};
  mesh.triangles = {{0, 2, 3}, {0, 1, 2}, {1, 4, 2}};
  const Surface surface = surface_of(mesh, 200.0);
  const BandMesh bands = builder_of(surface).build({0, 3});
  double area = 0.0;
  const std::vector<std::uint32_t> triangles = triangles_of(bands.indices);
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const glm::dvec3 a = bands.positions[triangles[t]];
    const glm::dvec3 b = bands.positions[triangles[t + 1]], c = bands.positions[triangles[t + 2]];
    area += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  EXPECT_NEAR(area, mesh_area(mesh), 1e-5);
  std::vector<Rgba8> out(bands.positions.size());
  colour_bands(bands, std::vector<Rgba8>(surface.slot_count(), Rgba8{1, 2, 3, 255}), out);
  for (const Rgba8 c : out) EXPECT_EQ(c, (Rgba8{1, 2, 3, 255}));
}

TEST(Bands, PackedNormalsKeepTheirDirection) {
  for (int k = 0; k < 5000; ++k) {
    const glm::vec3 n = glm::normalize(glm::vec3(std::sin(1.3f * static_cast<float>(k)),
                                                 std::sin(2.1f * static_cast<float>(k) + 1.0f),
                                                 std::sin(0.7f * static_cast<float>(k) + 2.0f)));
    ASSERT_LT(glm::distance(n, unpack_normal(pack_normal(n))), 1e-4f);
  }
}

TEST(Normals, CubeIsCrispAndTetrahedronSmoothWhenAsked) {
  const Mesh mesh = cube();
  const std::vector<glm::vec3> crisp = corner_normals(mesh, make_adjacency(mesh));
  for (const glm::vec3 n : crisp)
    EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0f, 1e-6f);
  const std::vector<glm::vec3> round = corner_normals(mesh, make_adjacency(mesh), 180.0);
  for (std::size_t c = 0; c < round.size(); ++c) {
    // Angle weights: each of the three faces counts a right angle however it is cut, so all corners look
    // outwards alike.
    const glm::dvec3 out = glm::normalize(mesh.corner(c / 3, static_cast<int>(c % 3)) - glm::dvec3(0.5));
    EXPECT_LT(glm::distance(glm::dvec3(round[c]), out), 1e-6);
  }
}

}  // namespace
}  // namespace verdigris
