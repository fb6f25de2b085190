#pragma once
// Scalar fields on a surface: looked up in space, so that nothing shows at the edges of triangles.

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"
#include "verdigris/synthesis/scalar_field.hpp"
#include "verdigris/synthesis/stretch_to_unit.hpp"

namespace verdigris {

/// Where a model lies in a field: the middle of its bounds in the middle of the field's window, its longest
/// side as long as `scale` times the window's. A scale of 2 shows twice as many features.
struct FieldPlacement {
  double scale = 1.0;
};

/// `field` at the centre of every evolving cell, [slot]; ghosts repeat their owners, as pictures need it,
/// other slots hold 0. Detail finer than two cells is left out. The same bits for any number of threads.
Field<float> field_on_surface(const Surface& surface, const ScalarField& field,
                              const FieldPlacement& placement = {});

}  // namespace verdigris
