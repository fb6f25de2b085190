#pragma once
// A flat square sheet, triangulated in several ways, and a coat on it.

#include <cmath>
#include <random>

#include "shapes.hpp"
#include "verdigris/io/read_material.hpp"
#include "verdigris/surface/owned_cells.hpp"
#include "verdigris/weathering/operators.hpp"

namespace sheets {

using namespace verdigris;

/// `side` cells long, n x n quads, jittered and with diagonals at random when `seed` is not 0; the rim stays
/// straight.
inline Mesh sheet(double side, int n, unsigned seed) {
  if (n <= 1) return shapes::square(side);
  std::mt19937 engine(seed);
  const auto uniform = [&] { return seed == 0 ? 0.0 : static_cast<double>(engine()) / 4294967296.0 - 0.5; };
  const double step = side / n;
  Mesh m = shapes::grid(n, n, false, false, [&](int i, int j) {
    const double dx = 0.5 * uniform() * (i > 0 && i < n), dy = 0.5 * uniform() * (j > 0 && j < n);
    return glm::dvec3((i + dx) * step, (j + dy) * step, 0.0);
  });
  if (seed != 0) shapes::flip_diagonals(m, engine);
  return m;
}

inline Surface surface_of(Mesh mesh, double cell = 1.0) {
  return make_surface(std::move(mesh), {.cell_size = cell});
}

/// Applies one operator, ghosts made as operators expect them.
inline OperatorReport apply(CoatedMetal& metal, const OperatorSetup& setup, const char* name,
                            const ParameterValues& values = {}) {
  const OperatorReport report = builtin_operators().find(name).apply(metal, setup, values);
  show_ghosts(setup.surface, metal);
  return report;
}

inline double total(const Surface& s, const Field<float>& field) {
  double sum = 0.0;
  each_owned(s, [&](std::uint32_t slot) { sum += static_cast<double>(field[slot]); });
  return sum;
}

}  // namespace sheets
