#pragma once
// Scan conversion of one triangle: which cells of a grid row are COMP-IN, PART-IN or OUT.

#include <cstdint>

#include "verdigris/surface/frame.hpp"

namespace verdigris {

/// Columns [begin, end) of a grid row; empty when begin == end.
struct ColumnRun {
  std::int32_t begin = 0, end = 0;
  bool empty() const { return begin >= end; }
};

/// The rows of one triangle's grid, from 0 (along AB) to row_count() - 1 (at C).
class TriangleScan {
 public:
  /// `owns_edge[k]`: whether centres exactly on edge k (0 = AB, 1 = BC, 2 = CA) are COMP-IN.
  TriangleScan(const Frame& frame, double cell_size, bool owns_bc, bool owns_ca);

  /// Rows that the triangle meets at all.
  std::int32_t row_count() const { return row_count_; }
  /// COMP-IN cells: the centre is in the triangle.
  ColumnRun comp_in(std::int32_t row) const;
  /// COMP-IN and PART-IN cells: the square meets the triangle's interior.
  ColumnRun active(std::int32_t row) const;

 private:
  // All in cells. Left edge AC: x = left_ * y; right edge BC: x = ab_ - right_ * y.
  double ab_, cy_, left_, right_;
  bool owns_bc_, owns_ca_;
  std::int32_t row_count_;
};

}  // namespace verdigris
