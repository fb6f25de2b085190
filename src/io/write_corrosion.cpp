#include "verdigris/io/write_corrosion.hpp"

#include <fmt/format.h>

#include <numeric>

#include "verdigris/io/replace_file.hpp"

namespace verdigris {

void write_corrosion_csv(const std::filesystem::path& target, std::span<const CorrosionNumbers> numbers) {
  ReplaceFile file(target);
  file.write(
      "step,years,new_cells,corroded_cells,gone_cells,share,mean_depth_um,mean_depth_of_corroded_um,"
      "greatest_depth_um,mass_loss_g_m2,perimeter,spots,mean_spot_cells,largest_spot_cells\n");
  for (const CorrosionNumbers& n : numbers) {
    file.write(fmt::format("{},{:.9g},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},", n.step, n.years,
                           n.new_cells, n.corroded, n.gone, n.share, n.mean_depth, n.mean_depth_corroded,
                           n.greatest_depth, n.mass_loss));
    if (!n.spots) {
      file.write(",,,\n");
      continue;
    }
    const auto& sizes = n.spots->sizes;
    const auto cells = static_cast<double>(std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
    file.write(fmt::format("{:.9g},{},{:.9g},{}\n", n.spots->perimeter, sizes.size(),
                           sizes.empty() ? 0.0 : cells / static_cast<double>(sizes.size()),
                           sizes.empty() ? 0 : sizes.front()));
  }
  file.commit();
}

void write_spots_csv(const std::filesystem::path& target, std::span<const CorrosionNumbers> numbers) {
  ReplaceFile file(target);
  file.write("step,cells_from,cells_to,spots\n");
  for (const CorrosionNumbers& n : numbers) {
    if (!n.spots) continue;
    const auto bins = spot_histogram(*n.spots);
    for (std::size_t k = 0; k < bins.size(); ++k)
      file.write(
          fmt::format("{},{},{},{}\n", n.step, std::uint64_t{1} << k, (std::uint64_t{2} << k) - 1, bins[k]));
  }
  file.commit();
}

}  // namespace verdigris
