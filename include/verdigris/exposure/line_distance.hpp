#pragma once
// How far places are from painted points and lines, along the surface.

#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A point, or points joined by lines: the straight lines in space, moved to the nearest surface.
using PaintedLine = std::vector<glm::dvec3>;

/// Distance along the surface to the nearest line, [slot] model units; `most` beyond that and where no way
/// leads.
///
/// Each cell keeps the point of the line that it was reached from, unfolded into its own plane: distances are
/// exact where the way is straight. Behind holes and saddles they turn corners at cells, and may be up to a
/// tenth off. One thread; time grows with the cells within `most`. Throws InputError without a point, for one
/// that is not finite, and with projected links, which have no planes to unfold.
Field<float> line_distance(const Surface& surface, std::span<const PaintedLine> lines,
                           double most = std::numeric_limits<float>::max());

/// "x y z, x y z; x y z": points separated by commas, lines by semicolons. Throws InputError naming `where`
/// and the column.
std::vector<PaintedLine> parse_lines(std::string_view text, std::string_view where);

}  // namespace verdigris
