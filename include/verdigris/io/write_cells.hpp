#pragma once
// Cells as data: VTK PolyData for ParaView and VTK's own readers, and tables for everything else.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// A named value for each slot, whole or real.
struct CellArray {
  std::string name;
  std::variant<const Field<std::int32_t>*, const Field<float>*> values;
};

/// Writes the owned (COMP-IN) cell centres as points, in slot order, each with a vertex cell, as VTK XML
/// PolyData
/// (.vtp, appended raw data, UInt64 headers). Point data: the given arrays as int32 or float32, `patch` as int32, `area` in
/// model units squared as float64. No time stamp: equal input, equal bytes. Streams; needs no memory beyond a
/// few rows. Throws InputError when the file cannot be written.
void write_cells_vtp(const std::filesystem::path& file, const Surface& surface,
                     std::span<const CellArray> arrays);

/// Sizes of the regions of a partition.
struct Region {
  std::uint64_t cells = 0;
  double area = 0.0;   ///< model units squared
  double share = 0.0;  ///< of all owned cells
};

/// [label] regions of `labels`, for labels 0..count-1; cells of label -1 belong to none.
std::vector<Region> measure_regions(const Surface& surface, const Field<std::int32_t>& labels,
                                    std::size_t count);

/// [step] owned cells reached in that step; index 0 are the seeds. Cells of arrival -1 are left out.
std::vector<std::uint64_t> arrival_curve(const Surface& surface, const Field<std::int32_t>& arrivals);

/// regions.csv: `label,seed_x,seed_y,seed_z,cells,area,share`, a row for each label.
void write_regions_csv(const std::filesystem::path& file, std::span<const Region> regions,
                       std::span<const glm::dvec3> seed_positions);

/// curve.csv: `step,changed,filled_share`, a row for each step from 0: Fig. 16 of Gobron & Chiba 1999.
void write_curve_csv(const std::filesystem::path& file, std::span<const std::uint64_t> changed,
                     std::uint64_t cells);

}  // namespace verdigris
