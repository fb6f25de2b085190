#pragma once
// A flat, periodic surface: the plane grid that cellular automata are usually run on, as patches that line
// up.

#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A torus of `width` x `height` cells that is flat all over: triangles with their longest side along the
/// rows, `patch` cells long, their grids lined up to one lattice. Cells have side 1. Patches own patch^2 / 4
/// cells. Throws InputError unless `patch` is even and at least 4, and width and height are multiples of it.
Surface make_flat_torus(std::uint32_t width, std::uint32_t height, std::uint32_t patch,
                        LinkKind links = LinkKind::unfolded);

/// Column and row (0 <= x < width, 0 <= y < height) on the lattice of a flat torus, from a cell's position.
struct TorusCell {
  std::uint32_t x, y;
};
TorusCell torus_cell(const Surface& torus, std::uint32_t slot, std::uint32_t width, std::uint32_t height);

}  // namespace verdigris
