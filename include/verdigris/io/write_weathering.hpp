#pragma once
// What became of a weathered surface, as tables and cells.

#include <filesystem>
#include <span>

#include "verdigris/weathering/timeline.hpp"

namespace verdigris {

/// timeline.csv, a row for each operation:
/// `operation,op,years,cells,added_um,removed_um,metal_um,bare_share,corroded_share,gone_share,damaged_share,
/// mean_loss_um,greatest_loss_um,mass_loss_g_m2`, then a column `NAME_um` for each coat there is in
/// the end, its mean thickness. added, removed and metal are means over all cells of what the operation laid
/// on coats, took off coats and off the metal. Throws InputError when the file cannot be written.
void write_timeline_csv(const std::filesystem::path& file, std::span<const TimelineRecord> records,
                        const CoatedMetal& metal, std::uint64_t cells);

/// cells.vtp: `metal_lost_um`, `metal_left_um`, `corroded_years` (-1: sound), `damage`, the thickness of each
/// coat as `NAME_um` and the bond of applied ones as `NAME_adhesion`. Throws as write_cells_vtp.
void write_weathered_cells(const std::filesystem::path& file, const Surface& surface,
                           const CoatedMetal& metal);

}  // namespace verdigris
