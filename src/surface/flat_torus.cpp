#include "verdigris/surface/flat_torus.hpp"

#include <fmt/format.h>

#include <cmath>

#include "verdigris/base/error.hpp"

namespace verdigris {

// Bands of height patch / 2. In an even band the sides along the rows lie at its lower edge from column 0, in
// an odd one shifted by half: so every long side has a triangle below and one above.
Surface make_flat_torus(std::uint32_t width, std::uint32_t height, std::uint32_t patch, LinkKind links) {
  if (patch < 4 || patch % 2 != 0 || width == 0 || height == 0 || width % patch != 0 || height % patch != 0)
    throw InputError("flat torus", fmt::format("{} x {} cells in patches {} long", width, height, patch),
                     "make the patch length even and at least 4, and width and height multiples of it");
  // Slots and half-edges are 32 bits; a triangle of patch^2 / 4 cells stores some 2 patch more.
  const double cells = static_cast<double>(width) * height,
               triangles = 4.0 * (width / patch) * (height / patch);
  if (cells + 2.0 * patch * triangles > 4.2e9 || triangles > 3e8)
    throw InputError("flat torus",
                     fmt::format("{} x {} cells in patches {} long are too many", width, height, patch),
                     "make it smaller, or its patches longer; 4e9 cells and their ghosts fit");
  const std::uint32_t across = width / patch, bands = 2 * (height / patch), half = patch / 2;
  Mesh mesh;
  // Triangle 2 i of a band stands on its long side, 2 i + 1 hangs from the band's upper edge.
  const auto index = [&](std::uint32_t band, std::uint32_t i, std::uint32_t hanging) {
    return 2 * (band % bands * across + i % across) + hanging;
  };
  Adjacency adjacency;
  for (std::uint32_t band = 0; band < bands; ++band)
    for (std::uint32_t i = 0; i < across; ++i) {
      const double x = static_cast<double>(i) * patch + (band % 2 == 0 ? 0.0 : half),
                   y = static_cast<double>(band) * half;
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(
          mesh.positions.end(),
          {{x, y, 0}, {x + patch, y, 0}, {x + half, y + half, 0}, {x + 3.0 * half, y + half, 0}});
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base + 3, base + 2, base + 1});
      // Standing: the hanging one of the band below; the hanging ones to its right and left in this band.
      // An odd band is shifted to the right by half: above an even one i meets i, above an odd one i meets i
      // + 1.
      const std::uint32_t under =
          band % 2 == 0 ? index(band + bands - 1, i + across - 1, 1) : index(band + bands - 1, i, 1);
      const std::uint32_t over = band % 2 == 0 ? index(band + 1, i, 0) : index(band + 1, i + 1, 0);
      const std::uint32_t standing = index(band, i, 0), hanging = index(band, i, 1);
      adjacency.opposite.insert(adjacency.opposite.end(),
                                {3 * under, 3 * hanging + 1, 3 * index(band, i + across - 1, 1) + 2, 3 * over,
                                 3 * standing + 1, 3 * index(band, i + 1, 0) + 2});
    }
  adjacency.kind.assign(adjacency.opposite.size(), EdgeKind::linked);
  return make_surface(std::move(mesh), std::move(adjacency), {.cell_size = 1.0, .links = links});
}

TorusCell torus_cell(const Surface& torus, std::uint32_t slot, std::uint32_t width, std::uint32_t height) {
  const glm::dvec3 p = torus.position(slot);
  return {static_cast<std::uint32_t>(std::floor(p.x)) % width,
          static_cast<std::uint32_t>(std::floor(p.y)) % height};
}

}  // namespace verdigris
