#pragma once
// The surface as strips and fans over cell centres, ready to be drawn, a chunk at a time.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/picture/cell_blend.hpp"
#include "verdigris/picture/colour.hpp"
#include "verdigris/picture/patch_bands.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Consecutive vertices that are the centres of consecutive slots.
struct CentreRun {
  std::uint32_t vertex, slot, count;
};

/// Consecutive vertices that are contour points; the first has the blend number `blend`.
struct ContourRun {
  std::uint32_t vertex, blend, count;
};

/// A unit vector as two 16-bit numbers, octahedrally projected (Cigolle et al. 2014), exact to 0.005 degrees.
using PackedNormal = std::array<std::int16_t, 2>;
PackedNormal pack_normal(glm::vec3 unit);
glm::vec3 unpack_normal(PackedNormal packed);

/// The bands of some patches. Every vertex is in exactly one run.
struct BandMesh {
  std::vector<glm::vec3> positions;   ///< model units, relative to BandBuilder::origin
  std::vector<PackedNormal> normals;  ///< [vertex], corner normals interpolated over the triangle
  std::vector<glm::vec3> directions;  ///< [vertex], those of the mesh interpolated; empty without relief
  BandIndices indices;
  std::vector<CentreRun> centres;
  std::vector<ContourRun> contours;
  std::vector<std::uint32_t> blend_begin;  ///< [blend] into `blends`, one more at the end
  std::vector<BlendSource> blends;         ///< weights of one blend sum to 1; empty: nothing near has a value

  std::size_t bytes() const;
};

/// A part of the surface: patches first <= p < last; of a single patch possibly only some bands.
struct BandRange {
  std::uint32_t first_patch, last_patch;
  std::uint32_t first_band = 0, last_band = 0xFFFFFFFFu;
};

/// Cuts the surface into ranges of about `slots` slots each: whole patches, large ones by bands.
std::vector<BandRange> band_ranges(const Surface& surface, std::size_t slots = 1u << 16);

/// Makes bands of any part of a surface. Keeps what is decided once for all of it: which slots have values at
/// all, and from where each mesh vertex takes its own.
///
/// The bands of all ranges are watertight: wherever two triangles are linked, both have the same points on
/// the common edge, at positions equal bit for bit. A contour point's value is the bilinear mean of the cells
/// around it, ghosts included, on each of the two sides, averaged: equal on both sides. Slots beyond a
/// boundary have no part in it. Where triangles are too small to own cells, contour points take the value of
/// the nearest mesh vertex that has one. Triangles of no area give nothing.
class BandBuilder {
 public:
  /// `normals` [3 * triangle + corner] as corner_normals gives them; `directions` [mesh vertex] as
  /// relief_directions does, if the bands are to be relieved. The surface shares its data and may go out of
  /// scope.
  BandBuilder(const Surface& surface, std::vector<glm::vec3> normals, std::vector<glm::vec3> directions = {});

  /// Bands of a part of the surface; may be called from several threads at once.
  BandMesh build(const BandRange& range) const;

  const Surface& surface() const { return blends_.surface(); }
  glm::dvec3 origin() const { return origin_; }  ///< centre of the mesh bounds

 private:
  friend class BandAssembly;
  void find_vertex_sources();
  void spread_vertex_sources();

  CellBlends blends_;
  std::vector<glm::vec3> normals_, directions_;
  glm::dvec3 origin_;
  std::vector<CellBlend> vertex_sources_;  // [mesh vertex]; a vertex without value has count 0
};

/// Vertex colours from slot colours [slot]: copies at centres, means in linear light weighted by alpha at
/// contour points (neutral grey where nothing near has a value). `out` has one element a vertex.
void colour_bands(const BandMesh& bands, std::span<const Rgba8> slot_colours, std::span<Rgba8> out);

}  // namespace verdigris
