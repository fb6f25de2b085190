#pragma once
// Cellular noise: distances to scattered points (Worley 1996, "A cellular texture basis function").

#include <cstdint>
#include <memory>
#include <string>

#include "verdigris/synthesis/scalar_field.hpp"

namespace verdigris {

/// One feature point in each cell of a lattice; the value is the distance to the nearest (F1), to the second
/// nearest (F2), or how much farther that is (F2-F1, 0 where two regions meet), in cells. The distances are
/// exact: cells are searched outwards until none can hold a nearer point. Seen too coarsely it fades to its
/// mean.
struct CellularNoise {
  static constexpr const char *name = "cellular", *summary = "cellular noise (Worley): distances to points";
  static constexpr int dimension = 3;
  std::string distance = "F1";
  std::string metric = "euclidean";
  int dimensions = 3;
  double frequency = 8.0;
  double jitter = 1.0;
  double period = 0.0;

  template <typename V>
  void parameters(V&& v) {
    v("distance", distance, {"F1", "F2", "F2-F1"}, "to the nearest point, the second, or their difference");
    v("metric", metric, {"euclidean", "manhattan", "chebyshev"}, "how distances are measured");
    v("dimensions", dimensions, 2, 3, "1", "coordinates it reads; 2 is fastest, models need 3");
    v("frequency", frequency, 1e-6, 1e6, "1/unit", "cells per unit of length");
    v("jitter", jitter, 0.0, 1.0, "1", "how far points stray: 0 is a grid, 1 anywhere in their cells");
    v("period", period, 0.0, 1e6, "unit", "repeat after this length along every axis; 0: never");
  }
  /// Throws InputError for a period without a cell.
  std::unique_ptr<ScalarField> make(std::uint64_t seed) const;
};

}  // namespace verdigris
