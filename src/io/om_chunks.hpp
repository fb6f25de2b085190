#pragma once
// The chunks of an OM file, checked before OpenMesh sees them: its reader asserts or trusts where it should
// doubt.

#include <cstdint>
#include <string>
#include <string_view>

#include "faults.hpp"

namespace verdigris::io {

/// What the header of an OM file says, and where in the file the data stands. A chunk that is not there has
/// no bytes.
struct OmChunks {
  std::uint32_t vertices = 0, faces = 0, edges = 0;
  std::string_view positions, uvs,
      colors;            ///< the data alone: float32 or float64, 2 float32, 3 bytes a vertex
  bool doubles = false;  ///< positions are float64

  /// Header, positions and topology as one OM file that OpenMesh can read without harm.
  std::string clean;
};

/// Walks over the chunks. Throws InputError when the file is cut off, of a version newer than 2.2, or refers
/// to vertices, half-edges or faces that are not there.
OmChunks check_om_chunks(Faults& faults);

}  // namespace verdigris::io
