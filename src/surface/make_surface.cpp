#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "joints.hpp"
#include "pair_sort.hpp"
#include "scan.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/base/large_memory.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

namespace {

constexpr std::size_t most_slots = 0xFFFFFF00u;  // slots are 32 bits
constexpr std::size_t patches_a_task = 256;

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

std::string clean_size(double size) {
  return fmt::format("{:.4g}", size);
}

// Refuses what cannot be built before any memory is taken.
void check(const Mesh& mesh, const SurfaceOptions& options) {
  const double h = options.cell_size;
  if (mesh.triangles.empty())
    throw InputError("", "the mesh has no triangles", "choose a model that has a surface");
  if (mesh.triangles.size() > 0x50000000u)
    throw InputError("", "more than 1.3e9 triangles", "split the model");
  const double area = mesh_area(mesh);
  if (!(area > 0.0) || !std::isfinite(area))
    throw InputError("", fmt::format("the mesh has an area of {}", area),
                     "choose a model with faces of finite, positive area");
  if (!(h > 0.0) || !std::isfinite(h))
    throw InputError("cell size", fmt::format("{} is not a positive length", h),
                     fmt::format("give a length in model units; {} makes about a million cells",
                                 clean_size(cell_size_for(mesh, 1e6))));
  const SurfaceEstimate estimate = estimate_surface(mesh, h);
  const double memory = physical_memory();
  const double need = estimate.run_bytes;
  if (estimate.slots < 0.98 * static_cast<double>(most_slots) && need < 0.9 * memory) return;
  const double scale =
      std::max(estimate.slots / (0.9 * static_cast<double>(most_slots)), need / (0.8 * memory));
  throw InputError(
      "cell size",
      fmt::format(
          "{} would make {:.3g} cells and take {:.3g} GB; this machine has {:.3g} GB and a surface holds "
          "at most {:.3g} cells",
          clean_size(h), estimate.cells, need / 1e9, memory / 1e9, static_cast<double>(most_slots)),
      fmt::format("use cells of {} model units or larger",
                  clean_size(std::isfinite(scale) ? h * std::sqrt(scale) : cell_size_for(mesh, 1e8))));
}

struct PatchSize {
  std::uint32_t rows = 0, slots = 0, owned = 0;
};

}  // namespace

class SurfaceBuilder {
 public:
  SurfaceBuilder(Mesh mesh, Adjacency adjacency, const SurfaceOptions& options)
      : projected_(options.links == LinkKind::projected) {
    surface_.mesh_ = std::make_shared<const Mesh>(std::move(mesh));
    surface_.adjacency_ = std::make_shared<const Adjacency>(std::move(adjacency));
    surface_.cell_size_ = options.cell_size;
    surface_.link_kind_ = options.links;
    make_frames();
    if (options.crease_angle < 180.0) mark_creases(options.crease_angle);
  }

  Surface build() {
    lay_rows();
    link();
    return std::move(surface_);
  }

 private:
  template <typename Work>
  void for_patches(Work&& work) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface_.patch_count(), patches_a_task),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t patch = range.begin(); patch < range.end(); ++patch) work(patch);
                      });
  }

  void make_frames() {
    const Mesh& mesh = *surface_.mesh_;
    surface_.frames_.resize(mesh.triangles.size());
    for_patches([&](std::size_t t) {
      surface_.frames_[t] = make_frame(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    });
  }

  void mark_creases(double degrees) {
    constexpr double pi = 3.14159265358979323846;
    // Rounding makes coplanar faces turn by some 1e-7 radians.
    const double least_cosine = std::cos(degrees * pi / 180.0) - 1e-9;
    const auto& opposite = surface_.adjacency_->opposite;
    std::vector<glm::dvec3> normals;
    for (const Frame& frame : surface_.frames_)
      normals.push_back(frame.cy > 0.0 ? frame.normal() : glm::dvec3(0.0));
    // A triangle of no area lies flat on what it touches with its longest edge, through others like it.
    for (int pass = 0; pass < 8; ++pass)
      for (std::size_t t = 0; t < normals.size(); ++t) {
        const std::uint32_t across = opposite[3 * t + surface_.frames_[t].first_corner];
        if (surface_.frames_[t].cy <= 0.0 && normals[t] == glm::dvec3(0.0) && across != Adjacency::none)
          normals[t] = normals[across / 3];
      }
    surface_.barred_.assign(opposite.size(), false);
    for (std::size_t e = 0; e < opposite.size(); ++e) {
      if (opposite[e] == Adjacency::none) continue;
      const glm::dvec3 &a = normals[e / 3], &b = normals[opposite[e] / 3];
      surface_.barred_[e] = a != glm::dvec3(0.0) && b != glm::dvec3(0.0) && glm::dot(a, b) < least_cosine;
    }
  }

  // A centre on the edge itself belongs to the triangle of lower index: one owner, and no bias in the count.
  TriangleScan scan(std::size_t patch) const {
    const Frame& frame = surface_.frames_[patch];
    const auto owns = [&](unsigned k) {
      const std::uint32_t across = surface_.adjacency_->opposite[3 * patch + (k + frame.first_corner) % 3];
      return across == Adjacency::none || patch < across / 3;
    };
    return TriangleScan(frame, surface_.cell_size_, owns(1), owns(2));
  }

  // Visits the rows of a patch from -1 up with what evolves, what is owned, and the columns to store.
  template <typename Visit>
  bool visit_rows(std::size_t patch, Visit&& visit) const {
    const TriangleScan triangle = scan(patch);
    const auto run = [&](std::int32_t row) {
      return projected_ ? triangle.active(row) : triangle.comp_in(row);
    };
    // Rows at the tip may own nothing.
    std::int32_t count = triangle.row_count();
    while (count > 0 && run(count - 1).empty()) --count;
    if (count == 0) return false;
    ColumnRun below, here, above = run(0);
    for (std::int32_t row = -1; row <= count; ++row) {
      ColumnRun stored{std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::min()};
      for (const ColumnRun& near : {below, here, above})
        if (!near.empty())
          stored = {std::min(stored.begin, near.begin - 1), std::max(stored.end, near.end + 1)};
      if (stored.begin > stored.end) stored = {0, 0};  // a gap near a needle's tip
      visit(here, projected_ ? triangle.comp_in(row) : here, stored);
      below = here;
      here = above;
      above = row + 2 < count ? run(row + 2) : ColumnRun{};
    }
    return true;
  }

  void lay_rows() {
    const std::size_t patches = surface_.patch_count();
    std::vector<PatchSize> size(patches);
    for_patches([&](std::size_t patch) {
      PatchSize s;
      visit_rows(patch, [&](ColumnRun, ColumnRun owned, ColumnRun stored) {
        ++s.rows;
        s.slots += static_cast<std::uint32_t>(stored.end - stored.begin);
        s.owned += static_cast<std::uint32_t>(owned.end - owned.begin);
      });
      size[patch] = s;
    });

    // Two slots of guard at the very beginning: slot - 1 of any stored cell is a slot.
    std::vector<std::uint32_t> slot_begin(patches + 1);
    surface_.row_begin_.resize(patches + 1);
    std::size_t rows = 0, slots = 2, owned = 0;
    for (std::size_t patch = 0; patch < patches; ++patch) {
      surface_.row_begin_[patch] = static_cast<std::uint32_t>(rows);
      slot_begin[patch] = static_cast<std::uint32_t>(slots);
      rows += size[patch].rows;
      slots += size[patch].slots;
      owned += size[patch].owned;
      if (slots > most_slots)
        throw InputError("cell size",
                         fmt::format("{} makes more than {} cells", surface_.cell_size_, most_slots),
                         "use larger cells");
    }
    surface_.row_begin_[patches] = static_cast<std::uint32_t>(rows);
    slots += 2;
    surface_.slot_count_ = slots;
    surface_.owned_count_ = owned;

    surface_.rows_ = large_vector(rows + 2, Row{});
    if (projected_) surface_.comp_in_.resize(rows);
    for_patches([&](std::size_t patch) {
      std::uint32_t slot = slot_begin[patch], row = surface_.row_begin_[patch];
      visit_rows(patch, [&](ColumnRun run, ColumnRun owned_run, ColumnRun stored) {
        const auto at = [&](std::int32_t column) {
          return slot + static_cast<std::uint32_t>(column - stored.begin);
        };
        Row& r = surface_.rows_[row + 1];
        r.begin = slot;
        r.base = at(0);
        r.run_begin = run.empty() ? slot : at(run.begin);
        r.run_end = run.empty() ? slot : at(run.end);
        if (projected_) {
          const SlotRun in{at(owned_run.begin), at(owned_run.end)};
          surface_.comp_in_[row] = owned_run.empty() ? SlotRun{slot, slot} : in;
        }
        slot += static_cast<std::uint32_t>(stored.end - stored.begin);
        ++row;
      });
    });
    surface_.rows_.front() = {0, 0, 0, 0};
    const auto end = static_cast<std::uint32_t>(slots - 2);
    surface_.rows_.back() = {end, end, end, end};
    make_row_hints();
  }

  void make_row_hints() {
    auto& hint = surface_.row_hint_;
    hint = large_vector((surface_.slot_count_ >> Surface::hint_shift) + 1, std::uint32_t{0});
    const auto rows = surface_.rows();
    std::size_t row = 0;
    for (std::size_t k = 0; k < hint.size(); ++k) {
      while (row + 1 < rows.size() && rows[row + 1].begin <= k << Surface::hint_shift) ++row;
      hint[k] = static_cast<std::uint32_t>(row);
    }
  }

  void link() {
    const std::size_t patches = surface_.patch_count();
    // rows[i + 1] of the last row of a patch is the next patch's first, or the row after the last.
    const PatchRows rows{{surface_.rows_.data() + 1, surface_.rows_.size() - 1},
                         surface_.row_begin_,
                         surface_.comp_in_,
                         surface_.cell_size_};
    const Unfolding unfolding(surface_.frames_, *surface_.adjacency_, surface_.barred_);
    const std::size_t tasks = (patches + patches_a_task - 1) / patches_a_task;
    std::vector<Joints> joints(tasks);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
      const std::size_t last = std::min(patches, (task + 1) * patches_a_task);
      for (std::size_t patch = task * patches_a_task; patch < last; ++patch)
        (projected_ ? find_edge_pairs : find_ghosts)(rows, unfolding, static_cast<std::uint32_t>(patch),
                                                     joints[task]);
    });
    std::size_t count = 0;
    for (const Joints& j : joints) {
      count += j.pairs.size();
      surface_.open_ghost_count_ += j.open;
      surface_.lost_ghost_count_ += j.lost;
    }
    std::vector<std::uint64_t> pairs;
    pairs.reserve(count);
    for (Joints& j : joints) {
      pairs.insert(pairs.end(), j.pairs.begin(), j.pairs.end());
      j.pairs = {};
    }
    if (projected_) {
      // A cell may be the nearest of several; each pair counts once.
      std::sort(pairs.begin(), pairs.end());
      pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    } else {
      sort_by_source(pairs, surface_.slot_count_);
    }
    surface_.ghost_count_ = pairs.size();
    surface_.links_ = Links(surface_.slot_count_, pairs);
  }

  Surface surface_;
  bool projected_;
};

Surface make_surface(Mesh mesh, const SurfaceOptions& options) {
  check(mesh, options);
  Adjacency adjacency = make_adjacency(mesh);
  return SurfaceBuilder(std::move(mesh), std::move(adjacency), options).build();
}

Surface make_surface(Mesh mesh, Adjacency adjacency, const SurfaceOptions& options) {
  check(mesh, options);
  return SurfaceBuilder(std::move(mesh), std::move(adjacency), options).build();
}

double cell_size_for(const Mesh& mesh, double cells) {
  return std::sqrt(mesh_area(mesh) / cells);
}

SurfaceEstimate estimate_surface(const Mesh& mesh, double cell_size) {
  SurfaceEstimate total;
  double rows = 0.0, ghosts = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Frame f = make_frame(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    const double ab = f.ab / cell_size, cy = f.cy / cell_size, cells = 0.5 * ab * cy;
    // Triangles that catch no centre take no rows; those around one cell do so in proportion.
    const double share = std::min(1.0, cells);
    const double joints = share * (2.0 * ab + 2.0 * cy + 4.0);
    total.cells += cells;
    ghosts += joints;
    rows += share * (cy + 2.0);
  }
  total.slots = total.cells + ghosts;
  // Links take a target and a bit a ghost; marks, ranks and row hints 5/16 of a byte a slot.
  total.bytes = 16.0 * rows + 4.125 * ghosts + 0.3125 * total.slots +
                static_cast<double>(mesh.triangles.size()) * static_cast<double>(sizeof(Frame) + 4);
  // At its end a run holds states, labels and arrivals, 12 bytes a slot, and a mark; while it is built, a
  // surface holds its links thrice over.
  total.run_bytes = total.bytes + std::max(12.125 * total.slots, 24.0 * ghosts);
  return total;
}

}  // namespace verdigris
