#pragma once
// Values given on the vertices or faces of a model, brought to its cells.

#include <span>
#include <string>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Linear interpolation of values on mesh vertices [vertex] to the centres of evolving cells; other slots
/// hold 0. Throws std::invalid_argument when there is not one value a vertex.
Field<float> interpolate_vertex_values(const Surface& surface, std::span<const double> values);

/// The value of its triangle [triangle] in every evolving cell; other slots hold 0.
/// Throws std::invalid_argument when there is not one value a triangle.
Field<float> spread_triangle_values(const Surface& surface, std::span<const double> values);

/// Values as a user gives them, one a vertex or one a face *of the file*, told apart by their number; `on`
/// says "vertices" or "faces" where that is not enough. Throws InputError, naming `where`, when they are
/// neither or may be both.
Field<float> file_values(const Surface& surface, std::span<const double> values, std::size_t file_vertices,
                         std::size_t file_faces, const std::string& on, const std::string& where);

}  // namespace verdigris
