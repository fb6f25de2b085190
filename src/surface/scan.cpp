#include "scan.hpp"

#include <algorithm>
#include <cmath>

namespace verdigris {

namespace {
// A centre this near to an edge, in cells, lies on it. Far above rounding, so that both triangles at an edge
// agree where their grids line up; far below anything a cell resolves.
constexpr double on_edge = 1e-3;

std::int32_t ceil_to_column(double x) {
  return static_cast<std::int32_t>(std::ceil(x));
}
}  // namespace

TriangleScan::TriangleScan(const Frame& frame, double cell_size, bool owns_bc, bool owns_ca)
    : ab_(frame.ab / cell_size),
      cy_(frame.cy / cell_size),
      left_(frame.cy > 0.0 ? frame.cx / frame.cy : 0.0),
      right_(frame.cy > 0.0 ? (frame.ab - frame.cx) / frame.cy : 0.0),
      owns_bc_(owns_bc),
      owns_ca_(owns_ca),
      row_count_(static_cast<std::int32_t>(std::ceil(cy_ - on_edge))) {
  // A sliver lower than the tolerance owns nothing.
  row_count_ = std::max(row_count_, 0);
}

ColumnRun TriangleScan::comp_in(std::int32_t row) const {
  const double y = row + 0.5;
  if (row < 0 || y >= cy_) return {};
  // Column i is in when left <= i + 0.5 <= right; on equality to within on_edge the owner decides.
  const double left = left_ * y - 0.5, right = ab_ - right_ * y - 0.5;
  const std::int32_t begin = ceil_to_column(owns_ca_ ? left - on_edge : left + on_edge);
  const std::int32_t end =
      static_cast<std::int32_t>(std::floor(owns_bc_ ? right + on_edge : right - on_edge)) + 1;
  return begin < end ? ColumnRun{begin, end} : ColumnRun{};
}

ColumnRun TriangleScan::active(std::int32_t row) const {
  // 0 <= cx <= ab: the triangle is widest at the lower side of the row.
  const double y = std::max(row, 0);
  if (row < 0 || y >= cy_ - on_edge) return {};
  const std::int32_t begin = static_cast<std::int32_t>(std::floor(left_ * y + on_edge));
  const std::int32_t end = ceil_to_column(ab_ - right_ * y - on_edge);
  return begin < end ? ColumnRun{begin, end} : ColumnRun{};
}

}  // namespace verdigris
