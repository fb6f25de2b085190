#pragma once
// The numbers of corrosion as tables.

#include <filesystem>
#include <span>

#include "verdigris/behaviours/corrosion_statistics.hpp"

namespace verdigris {

/// statistics.csv, a row for each step measured:
/// `step,years,new_cells,corroded_cells,gone_cells,share,mean_depth_um,mean_depth_of_corroded_um,
/// greatest_depth_um,mass_loss_g_m2,perimeter,spots,mean_spot_cells,largest_spot_cells`. The last four are
/// empty where spots were not measured; the perimeter is in model units. Throws InputError when the file
/// cannot be written.
void write_corrosion_csv(const std::filesystem::path& file, std::span<const CorrosionNumbers> numbers);

/// spots.csv, sizes of the spots at each step at which they were measured:
/// `step,cells_from,cells_to,spots`, a row for each power of two up to the largest.
void write_spots_csv(const std::filesystem::path& file, std::span<const CorrosionNumbers> numbers);

}  // namespace verdigris
