#pragma once
// Turtle lines as solids: a mesh to grow on, to render or to print.

#include <span>

#include "verdigris/mesh/mesh.hpp"
#include "verdigris/synthesis/turtle.hpp"

namespace verdigris {

struct TubeOptions {
  int sides = 8;  ///< of the polygon across a tube, 3 to 64
};

/// A tube round each line: each is closed, oriented outwards and manifold, and no two have a vertex in
/// common. Where lines branch or turn by more than 100 degrees, tubes overlap; at other bends they are
/// mitred. The polygon has the area of a circle of the line's width, so volumes are those of round tubes.
/// Lines of no length give nothing. Throws InputError when the mesh would have more than 20 million vertices.
Mesh make_tubes(std::span<const TurtleLine> lines, const TubeOptions& options = {});

/// Volume inside a closed, oriented mesh, by the divergence theorem; parts that overlap count each.
double enclosed_volume(const Mesh& mesh);

}  // namespace verdigris
