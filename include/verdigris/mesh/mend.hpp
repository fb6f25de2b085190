#pragma once
// The repairs that cannot change the shape: duplicate faces, and the orientation of an orientable component.

#include <cstddef>

#include "verdigris/mesh/mesh.hpp"

namespace verdigris {

/// What `mend` did and what it had to leave.
struct MendReport {
  std::size_t duplicates_removed = 0;  ///< triangles with the vertices of an earlier one
  std::size_t triangles_flipped = 0;
  std::size_t unorientable_components =
      0;  ///< left as they were (a Moebius strip has no consistent orientation)
};

/// Removes duplicate triangles, then turns triangles so that neighbours across every two-triangle edge agree.
/// In each component the smaller part is turned; a closed component is in the end turned so that its volume
/// is positive only if some triangle of it was turned at all. Components that cannot be oriented are left
/// untouched and counted.
Mesh mend(const Mesh& mesh, MendReport* report = nullptr);

}  // namespace verdigris
