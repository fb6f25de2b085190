#pragma once
// The cell surface: every triangle of a mesh on its own grid of square cells, the grids joined across edges.
// Source: Gobron & Chiba 1999, "3D Surface Cellular Automata and Their Applications".

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "verdigris/base/prefetch.hpp"
#include "verdigris/mesh/adjacency.hpp"
#include "verdigris/mesh/mesh.hpp"
#include "verdigris/surface/frame.hpp"
#include "verdigris/surface/links.hpp"

namespace verdigris {

/// One row of one patch's grid, a run of consecutive slots.
///
/// Column i of this row is slot `base + i` (mod 2^32), so the cell above slot s is `s - row.base +
/// above.base`. Cells that evolve are `run_begin <= slot < run_end`; the slots around them (to the begin of
/// the next row) are ghosts, or guards that stay empty. Every neighbour of an evolving cell has a slot.
struct Row {
  std::uint32_t begin;      ///< first slot of the row; it ends where the next row begins
  std::uint32_t run_begin;  ///< first evolving slot
  std::uint32_t run_end;    ///< one past the last; equal to run_begin when there is none
  std::uint32_t base;
};

/// A run of slots, [begin, end).
struct SlotRun {
  std::uint32_t begin, end;
};

/// Where a cell lies: patch (= triangle), row and column of its grid. The cell's square is
/// [column, column + 1] x [row, row + 1] cells, its centre at + 0.5.
struct CellRef {
  std::uint32_t patch;
  std::int32_t row, column;
};

/// All patches of a mesh, built once by make_surface, then const. Copies share their data.
///
/// *Slots* index fields: rows of all patches one after the other, ghosts and guards included. *Owned* cells
/// are COMP-IN: their centre lies in the triangle. A centre on an edge itself belongs to the triangle of
/// lower index.
class Surface {
 public:
  const Mesh& mesh() const { return *mesh_; }
  const Adjacency& adjacency() const { return *adjacency_; }
  double cell_size() const { return cell_size_; }  ///< side of a cell, model units
  LinkKind link_kind() const { return link_kind_; }
  std::size_t patch_count() const { return frames_.size(); }
  std::size_t slot_count() const { return slot_count_; }    ///< size of a field
  std::size_t owned_count() const { return owned_count_; }  ///< COMP-IN cells
  std::size_t ghost_count() const {
    return ghost_count_;
  }  ///< linked ghosts (unfolded) or pair ends (projected)
  std::size_t open_ghost_count() const {
    return open_ghost_count_;
  }  ///< ghosts beyond a boundary: always empty
  std::size_t lost_ghost_count() const {
    return lost_ghost_count_;
  }                           ///< ghosts with surface but no owned cell near
  std::size_t bytes() const;  ///< memory held beside the mesh

  const Frame& frame(std::size_t patch) const { return frames_[patch]; }
  std::span<const Frame> frames() const { return frames_; }
  /// Rows of all patches; one empty row stands before the first and after the last.
  std::span<const Row> rows() const { return {rows_.data() + 1, rows_.size() - 2}; }
  /// Indices into rows() of `patch`: its first row is grid row -1 (never evolving), then 0, 1, ... Empty for
  /// a patch without cells.
  std::uint32_t row_begin(std::size_t patch) const { return row_begin_[patch]; }
  std::uint32_t row_end(std::size_t patch) const { return row_begin_[patch + 1]; }
  std::span<const std::uint32_t> row_begins() const { return row_begin_; }
  /// Grid row of row index `row` of `patch`.
  std::int32_t grid_row(std::size_t patch, std::uint32_t row) const {
    return static_cast<std::int32_t>(row - row_begin_[patch]) - 1;
  }
  /// Owned (COMP-IN) slots of a row: all that evolve when links are unfolded, fewer when projected.
  SlotRun owned(std::uint32_t row) const {
    if (comp_in_.empty()) return {rows()[row].run_begin, rows()[row].run_end};
    return comp_in_[row];
  }
  /// Owned runs of all rows when links are projected; empty when unfolded, where run_begin and run_end tell.
  std::span<const SlotRun> owned_runs() const { return comp_in_; }
  /// Index into rows() of the row that holds `slot`.
  std::uint32_t row_of(std::uint32_t slot) const {
    std::uint32_t row = row_hint_[slot >> hint_shift];
    // A row's successor always exists: the empty one after the last.
    while (rows_[row + 2].begin <= slot) ++row;
    return row;
  }
  /// Asks for the memory that row_of(slot) begins with.
  [[gnu::always_inline]] void prefetch_row_of(std::uint32_t slot) const {
    prefetch(row_hint_.data() + (slot >> hint_shift));
  }
  /// Patch that holds row `row`.
  std::uint32_t patch_of_row(std::uint32_t row) const;
  CellRef cell(std::uint32_t slot) const;
  bool is_owned(std::uint32_t slot) const;

  /// Centre of a cell in grid coordinates of its patch, model units.
  glm::dvec2 centre(std::int32_t grid_row, std::int32_t column) const {
    return {(column + 0.5) * cell_size_, (grid_row + 0.5) * cell_size_};
  }
  /// Centre of a cell in model space.
  glm::dvec3 position(std::uint32_t slot) const;

  const Links& links() const { return links_; }
  /// [half-edge] true where a crease bars the way; empty when there is no such barrier.
  const std::vector<bool>& barred_edges() const { return barred_; }

 private:
  friend class SurfaceBuilder;
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const Adjacency> adjacency_;
  double cell_size_ = 0.0;
  LinkKind link_kind_ = LinkKind::unfolded;
  std::size_t slot_count_ = 0, owned_count_ = 0, ghost_count_ = 0, open_ghost_count_ = 0,
              lost_ghost_count_ = 0;
  std::vector<Frame> frames_;             // [patch]
  std::vector<std::uint32_t> row_begin_;  // [patch], one more at the end
  std::vector<Row> rows_;                 // one before, one after
  std::vector<SlotRun> comp_in_;          // [row], projected only
  static constexpr unsigned hint_shift = 5;
  std::vector<std::uint32_t> row_hint_;  // [slot / 32] row of slot 32 k
  Links links_;
  std::vector<bool> barred_;  // [half-edge], or empty
};

/// How to lay cells on a mesh.
struct SurfaceOptions {
  double cell_size = 0.0;  ///< model units, > 0
  LinkKind links = LinkKind::unfolded;
  double crease_angle = 181.0;  ///< degrees; edges whose faces turn by more are not linked (a barrier)
};

/// Lays every triangle on its grid and joins the grids; in parallel, the same bits for any number of threads.
/// Time and memory grow linearly with cells and triangles. Throws InputError for a mesh without triangles, a
/// cell size that is not a positive number, or one so small that slots would not fit 32 bits or memory would
/// not hold them; the message says which size would.
Surface make_surface(Mesh mesh, const SurfaceOptions& options);

/// The same with links between triangles that need not follow from the vertices: a periodic surface, say.
/// Edges joined by `adjacency` must be of one length.
Surface make_surface(Mesh mesh, Adjacency adjacency, const SurfaceOptions& options);

/// The cell size at which `mesh` gets about `cells` owned cells: sqrt(area / cells).
double cell_size_for(const Mesh& mesh, double cells);

/// What a surface of this cell size would take, without building it.
struct SurfaceEstimate {
  double cells = 0.0, slots = 0.0;
  double bytes = 0.0;      ///< of the surface
  double run_bytes = 0.0;  ///< of a run of Voronoi growth at its greatest, without its picture
};
SurfaceEstimate estimate_surface(const Mesh& mesh, double cell_size);

/// The cell owning the surface point nearest to `point`, for many points at once.
struct LocatedCell {
  std::uint32_t slot;  ///< an owned cell
  double distance;     ///< from the point to the nearest point of the surface, model units
};
/// Throws InputError when the surface owns no cell.
std::vector<LocatedCell> locate(const Surface& surface, std::span<const glm::dvec3> points);

}  // namespace verdigris
