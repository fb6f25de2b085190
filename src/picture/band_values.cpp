// Where contour points take their values from: bilinear weights over the cells around, and the colours that
// follow.
#include <algorithm>
#include <cmath>

#include "verdigris/picture/bands.hpp"

namespace verdigris {

BandBuilder::BandBuilder(const Surface& surface, std::vector<glm::vec3> normals)
    : surface_(surface), normals_(std::move(normals)) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  origin_ = 0.5 * (bounds.lower + bounds.upper);
  linked_.assign(surface.slot_count() / 64 + 1, 0);
  surface.links().for_each([&](std::uint32_t, std::span<const std::uint32_t> targets) {
    for (const std::uint32_t target : targets) linked_[target >> 6] |= std::uint64_t{1} << (target & 63);
  });
  find_vertex_sources();
  spread_vertex_sources();
}

BandBuilder::Sources BandBuilder::sources_at(std::uint32_t patch, glm::dvec2 p) const {
  constexpr double least_weight = 1e-4;  // as near to a grid line as centres are dropped beside the contour
  Sources sources;
  const std::uint32_t row_begin = surface_.row_begin(patch), row_end = surface_.row_end(patch);
  if (row_begin == row_end) return sources;
  const double x = p.x / surface_.cell_size() - 0.5, y = p.y / surface_.cell_size() - 0.5;
  const double i = std::floor(x), j = std::floor(y);
  const double fx = x - i, fy = y - j;
  double sum = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    const int di = corner & 1, dj = corner >> 1;
    const double weight = (di ? fx : 1.0 - fx) * (dj ? fy : 1.0 - fy);
    const std::int64_t row = static_cast<std::int64_t>(j) + dj + 1 + row_begin;  // grid row -1 comes first
    if (weight < least_weight || row < row_begin || row >= row_end) continue;
    const auto r = static_cast<std::size_t>(row);
    const std::int64_t end = r + 1 < surface_.rows().size()
                                 ? std::int64_t{surface_.rows()[r + 1].begin}
                                 : static_cast<std::int64_t>(surface_.slot_count());
    const Row& cells = surface_.rows()[r];
    // Column 0 is slot `base` modulo 2^32; the true slot is found from the first slot's column, without
    // wrapping.
    const std::int64_t first_column = static_cast<std::int32_t>(cells.begin - cells.base);
    const std::int64_t slot = cells.begin + (static_cast<std::int64_t>(i) + di - first_column);
    if (slot < cells.begin || slot >= end) continue;
    const auto s = static_cast<std::uint32_t>(slot);
    const bool evolves = s >= cells.run_begin && s < cells.run_end;
    if (!evolves && !((linked_[s >> 6] >> (s & 63)) & 1u)) continue;
    sources.cells[sources.count++] = {s, static_cast<float>(weight)};
    sum += weight;
  }
  for (std::uint8_t k = 0; k < sources.count; ++k)
    sources.cells[k].weight = static_cast<float>(sources.cells[k].weight / sum);
  return sources;
}

// A mesh vertex takes its value in its first patch that has one there: ghosts make all of them nearly equal,
// and all patches around it must show the same.
void BandBuilder::find_vertex_sources() {
  const Mesh& mesh = surface_.mesh();
  vertex_sources_.resize(mesh.positions.size());
  for (std::uint32_t patch = 0; patch < surface_.patch_count(); ++patch) {
    if (surface_.row_begin(patch) == surface_.row_end(patch)) continue;
    const Frame& frame = surface_.frame(patch);
    for (int k = 0; k < 3; ++k) {
      Sources& sources = vertex_sources_[mesh.triangles[patch][(frame.first_corner + k) % 3]];
      if (sources.count == 0) sources = sources_at(patch, frame.corner(k));
    }
  }
}

// Vertices out of reach of any cell take over from the neighbour of lowest index, ring after ring.
void BandBuilder::spread_vertex_sources() {
  const Mesh& mesh = surface_.mesh();
  const auto has_value = [&](std::uint32_t vertex) { return vertex_sources_[vertex].count > 0; };
  std::vector<std::uint32_t> open;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!has_value(mesh.triangles[t][k])) {
        open.push_back(t);
        break;
      }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> taken;  // (vertex, from)
  while (!open.empty()) {
    taken.clear();
    for (const std::uint32_t t : open)
      for (int k = 0; k < 3; ++k)
        for (int n = 1; n < 3; ++n) {
          const std::uint32_t vertex = mesh.triangles[t][k], from = mesh.triangles[t][(k + n) % 3];
          if (!has_value(vertex) && has_value(from)) taken.emplace_back(vertex, from);
        }
    if (taken.empty()) return;  // a component without cells
    std::sort(taken.begin(), taken.end());
    for (const auto& [vertex, from] : taken)
      if (!has_value(vertex)) vertex_sources_[vertex] = vertex_sources_[from];
    std::erase_if(open, [&](std::uint32_t t) {
      const glm::uvec3 v = mesh.triangles[t];
      return has_value(v[0]) && has_value(v[1]) && has_value(v[2]);
    });
  }
}

void colour_bands(const BandMesh& bands, std::span<const Rgba8> slot_colours, std::span<Rgba8> out) {
  constexpr Rgba8 neutral{186, 184, 178, 255};
  for (const CentreRun& run : bands.centres) {
    const auto from = slot_colours.subspan(run.slot, run.count);
    std::copy(from.begin(), from.end(), out.begin() + run.vertex);
  }
  for (const ContourRun& run : bands.contours)
    for (std::uint32_t k = 0; k < run.count; ++k) {
      const std::uint32_t begin = bands.blend_begin[run.blend + k],
                          end = bands.blend_begin[run.blend + k + 1];
      Rgba8& colour = out[run.vertex + k];
      colour = begin == end ? neutral : slot_colours[bands.blends[begin].slot];
      bool uniform = true;
      for (std::uint32_t n = begin + 1; n < end; ++n) uniform &= slot_colours[bands.blends[n].slot] == colour;
      if (uniform) continue;
      glm::vec3 sum(0.0f);
      float alpha = 0.0f;
      for (std::uint32_t n = begin; n < end; ++n) {
        const Rgba8 c = slot_colours[bands.blends[n].slot];
        const float share = bands.blends[n].weight * static_cast<float>(c.a);
        sum += share * to_linear(c);
        alpha += share;
      }
      colour = alpha > 0.0f
                   ? from_linear(sum / alpha, static_cast<std::uint8_t>(std::min(alpha + 0.5f, 255.0f)))
                   : Rgba8{0, 0, 0, 0};
    }
}

}  // namespace verdigris
