// Source: Gobron & Chiba 1999, "Triangle Strips and Triangle Fans".
#include "verdigris/picture/bands.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "verdigris/picture/contour.hpp"

namespace verdigris {

PackedNormal pack_normal(glm::vec3 n) {
  const float sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  float x = n.x / sum, y = n.y / sum;
  if (n.z < 0.0f) {
    const float folded = (1.0f - std::abs(y)) * (x < 0.0f ? -1.0f : 1.0f);
    y = (1.0f - std::abs(x)) * (y < 0.0f ? -1.0f : 1.0f);
    x = folded;
  }
  return {static_cast<std::int16_t>(std::lround(x * 32767.0f)),
          static_cast<std::int16_t>(std::lround(y * 32767.0f))};
}

glm::vec3 unpack_normal(PackedNormal packed) {
  glm::vec3 n(static_cast<float>(packed[0]) / 32767.0f, static_cast<float>(packed[1]) / 32767.0f, 0.0f);
  n.z = 1.0f - std::abs(n.x) - std::abs(n.y);
  const float fold = std::max(-n.z, 0.0f);
  n.x += n.x < 0.0f ? fold : -fold;
  n.y += n.y < 0.0f ? fold : -fold;
  return glm::normalize(n);
}

std::size_t BandMesh::bytes() const {
  return (positions.size() + directions.size()) * sizeof(glm::vec3) + normals.size() * sizeof(PackedNormal) +
         (indices.strips.size() + indices.fans.size() + blend_begin.size()) * sizeof(std::uint32_t) +
         centres.size() * sizeof(CentreRun) + contours.size() * sizeof(ContourRun) +
         blends.size() * sizeof(BlendSource);
}

std::vector<BandRange> band_ranges(const Surface& surface, std::size_t slots) {
  std::vector<BandRange> ranges;
  const auto patches = static_cast<std::uint32_t>(surface.patch_count());
  const auto slot_of_row = [&](std::uint32_t row) {
    return row < surface.rows().size() ? std::size_t{surface.rows()[row].begin} : surface.slot_count();
  };
  // A patch without cells still costs its contour: count it as some.
  constexpr std::size_t patch_cost = 32;
  std::size_t cost = 0;
  std::uint32_t first = 0;
  for (std::uint32_t patch = 0; patch < patches; ++patch) {
    const std::size_t own =
        slot_of_row(surface.row_end(patch)) - slot_of_row(surface.row_begin(patch)) + patch_cost;
    if (cost > 0 && cost + own > slots) {
      ranges.push_back({first, patch});
      first = patch;
      cost = 0;
    }
    cost += own;
    if (own > 2 * slots) {
      const std::uint32_t rows = surface.row_end(patch) - surface.row_begin(patch);
      const auto parts = static_cast<std::uint32_t>(std::min<std::size_t>(own / slots, rows));
      for (std::uint32_t k = 0; k < parts; ++k) {
        const std::uint32_t from = k * (rows / parts),
                            to = k + 1 == parts ? 0xFFFFFFFFu : (k + 1) * (rows / parts);
        ranges.push_back({patch, patch + 1, from, to});
      }
      first = patch + 1;
      cost = 0;
    }
  }
  if (first < patches) ranges.push_back({first, patches});
  return ranges;
}

/// Builds one BandMesh, patch after patch; keeps its buffers.
class BandAssembly {
 public:
  BandAssembly(const BandBuilder& builder, BandMesh& mesh)
      : builder_(builder), surface_(builder.surface()), mesh_(mesh) {}

  void add(std::uint32_t patch, std::size_t first_band, std::size_t last_band) {
    patch_ = patch;
    frame_ = &surface_.frame(patch);
    if (!(frame_->cy > 0.0)) return;
    base_ = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto blend = static_cast<std::uint32_t>(mesh_.blend_begin.size());
    for (int k = 0; k < 3; ++k) add_corner(k);
    outline_.ab.clear();
    outline_.bc.clear();
    outline_.ac.clear();
    add_edge(0, outline_.ab, false);
    add_edge(1, outline_.bc, false);
    add_edge(2, outline_.ac, true);
    mesh_.contours.push_back({base_, blend, outline_.size()});

    find_owned();
    lines_.clear();
    band_lines(outline_, surface_.cell_size(), owned_, lines_);
    last_band = std::min(last_band, lines_.size() + 1);
    line_vertex_.assign(lines_.size(), 0);
    const std::size_t first_line = first_band == 0 ? 0 : first_band - 1;
    for (std::size_t k = first_line; k < std::min(last_band, lines_.size()); ++k) add_centres(k);
    triangulate_bands(*frame_, surface_.cell_size(), outline_, lines_, line_vertex_, first_band, last_band,
                      base_, mesh_.indices);
  }

 private:
  int mesh_corner(int k) const { return (frame_->first_corner + k) % 3; }

  void add_vertex(glm::dvec3 position, glm::dvec2 p) {
    mesh_.positions.push_back(glm::vec3(position - builder_.origin_));
    const double c = p.y / frame_->cy, b = (p.x - c * frame_->cx) / frame_->ab;
    const glm::vec3* corner = builder_.normals_.data() + std::size_t{3} * patch_;
    const glm::vec3 n = static_cast<float>(1.0 - b - c) * corner[mesh_corner(0)] +
                        static_cast<float>(b) * corner[mesh_corner(1)] +
                        static_cast<float>(c) * corner[mesh_corner(2)];
    mesh_.normals.push_back(pack_normal(n == glm::vec3(0.0f) ? corner[0] : n));
  }

  const glm::vec3& direction(std::uint32_t vertex) const { return builder_.directions_[vertex]; }
  bool with_directions() const { return !builder_.directions_.empty(); }

  void add_corner(int k) {
    const std::uint32_t vertex = surface_.mesh().triangles[patch_][mesh_corner(k)];
    add_vertex(surface_.mesh().positions[vertex], frame_->corner(k));
    if (with_directions()) mesh_.directions.push_back(direction(vertex));
    mesh_.blend_begin.push_back(static_cast<std::uint32_t>(mesh_.blends.size()));
    append(builder_.vertex_sources_[vertex], 1.0f);
  }

  void append(const CellBlend& sources, float factor) {
    for (std::uint8_t k = 0; k < sources.count; ++k)
      mesh_.blends.push_back({sources.cells[k].slot, factor * sources.cells[k].weight});
  }

  void add_edge(int frame_edge, std::vector<OutlinePoint>& side, bool backwards) {
    const SharedEdge edge = shared_edge(surface_, patch_, frame_edge);
    points_.clear();
    edge_contour(edge.own, edge.across == Adjacency::none ? nullptr : &edge.other,
                 glm::distance(edge.from, edge.to), surface_.cell_size(), points_);
    if (edge.reversed != backwards) std::reverse(points_.begin(), points_.end());
    for (const ContourPoint& point : points_) {
      const glm::dvec2 p = glm::mix(edge.own.from, edge.own.to, point.t);
      side.push_back({p, point.row});
      add_vertex(glm::mix(edge.from, edge.to, point.t), p);
      if (with_directions())
        mesh_.directions.push_back(
            glm::mix(direction(edge.low), direction(edge.high), static_cast<float>(point.t)));
      mesh_.blend_begin.push_back(static_cast<std::uint32_t>(mesh_.blends.size()));
      add_edge_sources(edge, point.t, p);
    }
  }

  void add_edge_sources(const SharedEdge& edge, double t, glm::dvec2 p) {
    const CellBlend own = builder_.blends_.at(patch_, p);
    CellBlend other;
    if (edge.across != Adjacency::none)
      other = builder_.blends_.at(edge.across / 3, glm::mix(edge.other.from, edge.other.to, t));
    if (own.count == 0 && other.count == 0)
      return append(builder_.vertex_sources_[t < 0.5 ? edge.low : edge.high], 1.0f);
    const float share = own.count == 0 || other.count == 0 ? 1.0f : 0.5f;
    // The lower patch first on both sides, so that both add the same numbers in the same order.
    const bool own_first = edge.across == Adjacency::none || patch_ < edge.across / 3;
    append(own_first ? own : other, share);
    append(own_first ? other : own, share);
  }

  // The owned columns of each grid row.
  void find_owned() {
    owned_.clear();
    const std::uint32_t begin = surface_.row_begin(patch_), end = surface_.row_end(patch_);
    for (std::uint32_t row = begin; row < end; ++row) {
      if (surface_.grid_row(patch_, row) < 0) continue;
      const SlotRun run = surface_.owned(row);
      const std::uint32_t base = surface_.rows()[row].base;
      owned_.push_back(run.begin == run.end ? ColumnRun{}
                                            : ColumnRun{static_cast<std::int32_t>(run.begin - base),
                                                        static_cast<std::int32_t>(run.end - base)});
    }
  }

  void add_centres(std::size_t k) {
    const BandLine& line = lines_[k];
    line_vertex_[k] = static_cast<std::uint32_t>(mesh_.positions.size());
    if (line.columns.begin >= line.columns.end) return;
    const Row& row = surface_.rows()[surface_.row_begin(patch_) + static_cast<std::uint32_t>(line.row + 1)];
    mesh_.centres.push_back({line_vertex_[k], row.base + static_cast<std::uint32_t>(line.columns.begin),
                             static_cast<std::uint32_t>(line.columns.end - line.columns.begin)});
    for (std::int32_t i = line.columns.begin; i < line.columns.end; ++i) {
      const glm::dvec2 p = surface_.centre(line.row, i);
      add_vertex(frame_->to_model(p), p);
      if (!with_directions()) continue;
      const auto c = static_cast<float>(p.y / frame_->cy);
      const auto b = static_cast<float>((p.x - p.y / frame_->cy * frame_->cx) / frame_->ab);
      const glm::uvec3 triangle = surface_.mesh().triangles[patch_];
      mesh_.directions.push_back((1.0f - b - c) * direction(triangle[mesh_corner(0)]) +
                                 b * direction(triangle[mesh_corner(1)]) +
                                 c * direction(triangle[mesh_corner(2)]));
    }
  }

  const BandBuilder& builder_;
  const Surface& surface_;
  BandMesh& mesh_;
  std::uint32_t patch_ = 0, base_ = 0;
  const Frame* frame_ = nullptr;
  Outline outline_;
  std::vector<ContourPoint> points_;
  std::vector<ColumnRun> owned_;
  std::vector<BandLine> lines_;
  std::vector<std::uint32_t> line_vertex_;
};

BandMesh BandBuilder::build(const BandRange& range) const {
  const Surface& surface = blends_.surface();
  BandMesh mesh;
  if (range.last_band == 0xFFFFFFFFu && range.first_band == 0) {  // a fair guess spares half the copying
    const std::uint32_t first = surface.row_begin(range.first_patch),
                        last = surface.row_end(range.last_patch - 1);
    const std::size_t slots =
        last > first ? surface.rows()[last - 1].run_end - surface.rows()[first].begin : 0;
    mesh.positions.reserve(slots + 16 * (range.last_patch - range.first_patch));
    mesh.normals.reserve(mesh.positions.capacity());
  }
  BandAssembly assembly(*this, mesh);
  for (std::uint32_t patch = range.first_patch; patch < range.last_patch; ++patch)
    assembly.add(patch, range.first_band, range.last_band);
  mesh.blend_begin.push_back(static_cast<std::uint32_t>(mesh.blends.size()));
  return mesh;
}

}  // namespace verdigris
