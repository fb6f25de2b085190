#pragma once

#include "verdigris/mesh/mesh.hpp"

namespace verdigris::meshes {

/// An admiralty anchor hanging upright: ring, stock, shank, arms and flukes; metres, y up, closed.
Mesh make_anchor();

/// A bear that sits on a plinth with ledges: decimetres, y up, closed.
Mesh make_bear();

/// A gabled roof of sheet metal with standing seams and a chimney, on a slab: metres, y up, closed.
Mesh make_roof();

}  // namespace verdigris::meshes
