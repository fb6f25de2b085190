#pragma once
// Layers as relief: their thickness moves the surface, and bends its normals.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/picture/bands.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// How far each cell stands out, and how the surface leans there.
struct Relief {
  std::vector<float> heights;     ///< [slot] model units, outwards; ghosts included
  std::vector<glm::vec3> slopes;  ///< [slot] gradient of the height along the surface, in model space
};

/// Makes reliefs of one surface, any number of them.
class ReliefMaker {
 public:
  explicit ReliefMaker(const Surface& surface) : blends_(surface), ghosts_(blends_) {}

  /// `heights` [slot] of the owned cells, in model units; those of ghosts follow. Slopes are central
  /// differences over the neighbours, one-sided at a boundary.
  Relief operator()(std::vector<float> heights) const;

 private:
  CellBlends blends_;
  GhostBlends ghosts_;
};

/// [mesh vertex] the way in which it moves for a height of 1: the mean of the normals around, angle-weighted,
/// so long that flat and right-angled surroundings move out by 1 too, and never longer than 2. One for all
/// triangles of a vertex, so that no crease opens. Triangles of no area do not count.
std::vector<glm::vec3> relief_directions(const Mesh& mesh);

/// Moves the vertices of `bands`, made by a BandBuilder with relief directions, and bends their normals.
/// Where triangles meet the height is the mean of both sides (Gobron & Chiba 1999, Fig. 20), so that what was
/// watertight stays so, bit for bit. The spans have an element a vertex.
void relieve_bands(const BandMesh& bands, const Relief& relief, std::span<glm::vec3> positions,
                   std::span<PackedNormal> normals);

/// Removes the triangles (three indices each) that lie wholly in a hole: all corners less than half present.
void drop_holes(std::vector<std::uint32_t>& triangles, std::span<const std::uint8_t> present);

}  // namespace verdigris
