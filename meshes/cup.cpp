// The counterpart of the cup in Gobron & Chiba 1999, figures 2 and 22 ("less than 450 input triangles").

#include "cup.hpp"

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>

#include "rings.hpp"

namespace verdigris::meshes {
namespace {

/// One ring of the profile, from the underside up the outer wall, over the lip and down to the inner floor.
struct ProfileRing {
  double radius, y;   // mm
  int count;          // vertices round: most at the lip, where the silhouette shows them
  double handle = 0;  // mm, half the width of the handle where it meets this ring; 0: evenly spaced
};

constexpr double underside_y = 3.0, floor_y = 7.5;
constexpr std::array<ProfileRing, 12> profile{{
    {20.0, 0.0, 12},        // foot ring, inner edge
    {24.0, 0.0, 14},        // foot ring, outer edge
    {22.6, 4.5, 14},        // neck above the foot
    {31.6, 12.5, 16, 5.5},  // bowl
    {36.9, 26.5, 16, 5.8},
    {39.4, 49.5, 16, 6.6},
    {40.5, 64.0, 16, 6.6},
    {43.0, 78.4, 18},  // lip
    {41.4, 80.0, 18},
    {39.4, 78.2, 18},
    {34.2, 30.0, 12},  // inside
    {20.0, 9.0, 8},
}};
constexpr std::size_t handle_end = 3, handle_start = 5;  // the rings below the two openings

/// The opening of a band, counter-clockwise from its lower corner on the side of -angle, or a ring of the
/// handle in the same order: corner, inner middle, corner, corner, outer middle, corner.
using Loop = std::array<std::uint32_t, 6>;

Loop opening(const Ring& below, const Ring& above) {
  return {below.at(-1), below.at(0), below.at(1), above.at(1), above.at(0), above.at(-1)};
}

glm::dvec3 centre(const Mesh& mesh, const Loop& loop) {
  glm::dvec3 sum(0.0);
  for (const auto vertex : loop) sum += mesh.positions[vertex];
  return sum / static_cast<double>(loop.size());
}

/// A cross-section of the handle: a flattened hexagon across the curve.
struct Section {
  double t;                 // place on the curve, 0..1
  double width, thickness;  // mm, half across and half from the inner to the outer side
};

constexpr std::array<Section, 7> sections{{
    {0.09, 5.4, 5.2},
    {0.24, 4.8, 4.2},
    {0.39, 4.6, 3.8},
    {0.53, 4.6, 3.8},
    {0.67, 4.6, 3.8},
    {0.81, 4.7, 4.0},
    {0.93, 5.0, 4.8},
}};
constexpr double corner = 0.62;  // of the thickness, where the sides begin

Loop add_section(Mesh& mesh, const Section& section, const std::array<glm::dvec3, 4>& bezier) {
  const double t = section.t, s = 1 - t;
  const glm::dvec3 point =
      s * s * s * bezier[0] + 3 * s * s * t * bezier[1] + 3 * s * t * t * bezier[2] + t * t * t * bezier[3];
  const glm::dvec3 along =
      glm::normalize(s * s * (bezier[1] - bezier[0]) + 2 * s * t * (bezier[2] - bezier[1]) +
                     t * t * (bezier[3] - bezier[2]));
  const glm::dvec3 inward = glm::dvec3(along.y, -along.x, 0.0) * section.thickness;
  const glm::dvec3 side = glm::dvec3(0.0, 0.0, -1.0) * section.width;  // angles grow towards -z
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(point + corner * inward - side);
  mesh.positions.push_back(point + inward);
  mesh.positions.push_back(point + corner * inward + side);
  mesh.positions.push_back(point - corner * inward + side);
  mesh.positions.push_back(point - inward);
  mesh.positions.push_back(point - corner * inward - side);
  return {first, first + 1, first + 2, first + 3, first + 4, first + 5};
}

void join(Mesh& mesh, const Loop& from, const Loop& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.size();
    const bool mirrored = i == 1 || i > 3;  // the diagonals on one side mirror those on the other
    if (mirrored) {
      mesh.triangles.emplace_back(from[i], from[next], to[i]);
      mesh.triangles.emplace_back(from[next], to[next], to[i]);
    } else {
      mesh.triangles.emplace_back(from[i], from[next], to[next]);
      mesh.triangles.emplace_back(from[i], to[next], to[i]);
    }
  }
}

}  // namespace

Mesh make_cup() {
  Mesh mesh;
  std::vector<Ring> rings{add_pole(mesh, underside_y)};
  for (const ProfileRing& ring : profile) {
    rings.push_back(add_ring(mesh, ring.radius, ring.y,
                             ring.handle > 0 ? angles_with_columns(ring.count, ring.handle / ring.radius)
                                             : even_angles(ring.count)));
  }
  rings.push_back(add_pole(mesh, floor_y));
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    stitch(mesh, rings[i], rings[i + 1], i == handle_start + 1 || i == handle_end + 1);
  }

  const Loop start = opening(rings[handle_start + 1], rings[handle_start + 2]);
  Loop end = opening(rings[handle_end + 1], rings[handle_end + 2]);
  end = {end[5], end[4], end[3], end[2], end[1], end[0]};  // the handle arrives with its inner side up
  const glm::dvec3 top = centre(mesh, start), bottom = centre(mesh, end);
  const std::array<glm::dvec3, 4> bezier{top, top + glm::dvec3(44.0, 20.0, 0.0),
                                         bottom + glm::dvec3(48.0, 0.0, 0.0), bottom};
  Loop last = start;
  for (const Section& section : sections) {
    const Loop loop = add_section(mesh, section, bezier);
    join(mesh, last, loop);
    last = loop;
  }
  join(mesh, last, end);
  return mesh;
}

}  // namespace verdigris::meshes
