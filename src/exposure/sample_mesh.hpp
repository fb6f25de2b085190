#pragma once
// Points of the surface at which something costly is computed, and triangles between them: the mesh itself,
// refined where it is coarse. Cells take values by linear interpolation, so that no triangle edge shows.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A place where values are computed. The corners of several triangles are one sample where the surface is
/// smooth, and several at a crease, each with a normal of its own.
struct Sample {
  glm::dvec3 position, normal;  ///< normal: unit, the mean of the triangles that share the sample
  glm::dvec3 inward{0.0};       ///< towards the middle of the triangles that share it, any length
  std::uint32_t faces[2];       ///< the triangles it lies in or between; none at a vertex of the mesh
};

/// Samples and pieces, conforming: a refined edge has the same samples on both sides.
class SampleMesh {
 public:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  struct Piece {
    std::array<std::uint32_t, 3> samples;
    std::uint32_t patch;
  };

  /// The triangles of the mesh. Edges that are not linked are creases, and those whose faces turn by more
  /// than `crease_angle` degrees.
  SampleMesh(const Surface& surface, double crease_angle);

  const std::vector<Sample>& samples() const { return samples_; }
  /// Those of one patch stand together, patches ascending.
  const std::vector<Piece>& pieces() const { return pieces_; }

  /// Halves the edges (a, b) for which `split` holds, and what has to be halved with them: the longest edge
  /// of a piece always is (Rivara 1984), so that pieces stay as round as they were. Returns how many samples
  /// came to it; they are the last.
  std::size_t refine(const std::function<bool(std::uint32_t a, std::uint32_t b)>& split);
  /// Refines until no edge is longer than `length`, model units.
  void refine_to(double length);

  double edge_length(std::uint32_t a, std::uint32_t b) const;

 private:
  std::vector<Sample> samples_;
  std::vector<Piece> pieces_;
};

/// Values [sample] interpolated to evolving cells, ghosts included.
Field<float> values_at_cells(const Surface& surface, const SampleMesh& mesh, std::span<const float> values);

}  // namespace verdigris
