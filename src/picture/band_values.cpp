// Where contour points take their values from: bilinear weights over the cells around, and the colours that
// follow.
#include <algorithm>
#include <cmath>

#include "verdigris/picture/bands.hpp"

namespace verdigris {

BandBuilder::BandBuilder(const Surface& surface, std::vector<glm::vec3> normals,
                         std::vector<glm::vec3> directions)
    : blends_(surface), normals_(std::move(normals)), directions_(std::move(directions)) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  origin_ = 0.5 * (bounds.lower + bounds.upper);
  find_vertex_sources();
  spread_vertex_sources();
}

// A mesh vertex takes its value in its first patch that has one there: ghosts make all of them nearly equal,
// and all patches around it must show the same.
void BandBuilder::find_vertex_sources() {
  const Surface& surface = blends_.surface();
  const Mesh& mesh = surface.mesh();
  vertex_sources_.resize(mesh.positions.size());
  for (std::uint32_t patch = 0; patch < surface.patch_count(); ++patch) {
    if (surface.row_begin(patch) == surface.row_end(patch)) continue;
    const Frame& frame = surface.frame(patch);
    for (int k = 0; k < 3; ++k) {
      CellBlend& sources = vertex_sources_[mesh.triangles[patch][(frame.first_corner + k) % 3]];
      if (sources.count == 0) sources = blends_.at(patch, frame.corner(k));
    }
  }
}

// Vertices out of reach of any cell take over from the neighbour of lowest index, ring after ring.
void BandBuilder::spread_vertex_sources() {
  const Mesh& mesh = surface().mesh();
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
