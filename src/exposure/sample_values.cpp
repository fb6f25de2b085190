// From samples to cells: the pieces of a patch are scanned like triangles.

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "sample_mesh.hpp"
#include "verdigris/surface/ghost_values.hpp"

namespace verdigris {

namespace {

// A piece in the plane of its patch, counter-clockwise as the triangle is.
struct FlatPiece {
  glm::dvec2 p[3];
  float value[3];

  glm::dvec3 weights(glm::dvec2 q) const {
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    if (!(area > 0.0)) return {-1e9, 0.0, 0.0};
    const double b = cross(q - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], q - p[0]) / area;
    return {1.0 - b - c, b, c};
  }
  float at(glm::dvec3 w) const {
    w = {std::max(w.x, 0.0), std::max(w.y, 0.0), std::max(w.z, 0.0)};
    return static_cast<float>((w.x * value[0] + w.y * value[1] + w.z * value[2]) / (w.x + w.y + w.z));
  }
};

class PatchValues {
 public:
  PatchValues(const Surface& surface, std::uint32_t patch, Field<float>& field)
      : surface_(surface), patch_(patch), field_(field) {}

  void fill(std::span<const FlatPiece> pieces) {
    const std::uint32_t first = surface_.row_begin(patch_), last = surface_.row_end(patch_);
    if (first == last) return;
    const double size = surface_.cell_size();
    if (pieces.size() > 1)
      for (const FlatPiece& piece : pieces) scan(piece, first, last, size);
    // What lies in no piece, by rounding or because pairs reach over edges, takes the nearest.
    for (std::uint32_t r = first; r < last; ++r) {
      const Row& row = surface_.rows()[r];
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
        if (pieces.size() > 1 && !std::isnan(field_[slot])) continue;
        field_[slot] = nearest(pieces, centre(r, slot, row));
      }
    }
  }

 private:
  glm::dvec2 centre(std::uint32_t r, std::uint32_t slot, const Row& row) const {
    return surface_.centre(surface_.grid_row(patch_, r), static_cast<std::int32_t>(slot - row.base));
  }

  void scan(const FlatPiece& piece, std::uint32_t first, std::uint32_t last, double size) {
    const auto [low, high] = std::minmax({piece.p[0].y, piece.p[1].y, piece.p[2].y});
    const auto [left, right] = std::minmax({piece.p[0].x, piece.p[1].x, piece.p[2].x});
    // Grid row -1 is the first stored.
    const auto from = static_cast<std::int64_t>(std::floor(low / size - 0.5)),
               to = static_cast<std::int64_t>(std::ceil(high / size - 0.5));
    for (std::int64_t grid = std::max<std::int64_t>(from, 0); grid <= to; ++grid) {
      const auto r = static_cast<std::uint32_t>(first + 1 + grid);
      if (r >= last) break;
      const Row& row = surface_.rows()[r];
      const auto column = [&](double x) {
        return static_cast<std::int64_t>(std::floor(x / size - 0.5)) -
               static_cast<std::int64_t>(static_cast<std::int32_t>(row.run_begin - row.base));
      };
      const std::int64_t count = row.run_end - row.run_begin;
      const std::int64_t begin = std::clamp<std::int64_t>(column(left), 0, count),
                         end = std::clamp<std::int64_t>(column(right) + 2, 0, count);
      for (std::int64_t k = begin; k < end; ++k) {
        const auto slot = row.run_begin + static_cast<std::uint32_t>(k);
        const glm::dvec3 w = piece.weights(centre(r, slot, row));
        if (w.x >= -1e-9 && w.y >= -1e-9 && w.z >= -1e-9) field_[slot] = piece.at(w);
      }
    }
  }

  static float nearest(std::span<const FlatPiece> pieces, glm::dvec2 q) {
    double best = -std::numeric_limits<double>::infinity();
    float value = 0.0f;
    for (const FlatPiece& piece : pieces) {
      const glm::dvec3 w = piece.weights(q);
      const double least = std::min({w.x, w.y, w.z});
      if (least <= best) continue;
      best = least;
      value = piece.at(w);
    }
    return value;
  }

  const Surface& surface_;
  std::uint32_t patch_;
  Field<float>& field_;
};

}  // namespace

Field<float> values_at_cells(const Surface& surface, const SampleMesh& mesh, std::span<const float> values) {
  if (values.size() != mesh.samples().size()) throw std::invalid_argument("not one value a sample");
  const auto& pieces = mesh.pieces();
  std::vector<std::size_t> begin(surface.patch_count() + 1, 0);
  for (const SampleMesh::Piece& p : pieces) ++begin[p.patch + 1];
  for (std::size_t p = 0; p < surface.patch_count(); ++p) begin[p + 1] += begin[p];
  Field<float> field(surface.slot_count(), std::numeric_limits<float>::quiet_NaN());
  tbb::parallel_for(std::size_t{0}, surface.patch_count(), [&](std::size_t patch) {
    std::vector<FlatPiece> flat;
    for (std::size_t k = begin[patch]; k < begin[patch + 1]; ++k) {
      FlatPiece piece{};
      for (int j = 0; j < 3; ++j) {
        const std::uint32_t s = pieces[k].samples[j];
        piece.p[j] = surface.frame(patch).to_plane(mesh.samples()[s].position);
        piece.value[j] = values[s];
      }
      flat.push_back(piece);
    }
    PatchValues(surface, static_cast<std::uint32_t>(patch), field).fill(flat);
  });
  for (float& v : field)
    if (std::isnan(v)) v = 0.0f;  // guards, and ghosts before they are filled
  copy_to_ghosts(surface, field);
  return field;
}

}  // namespace verdigris
