#include "verdigris/io/write_weathering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "verdigris/io/replace_file.hpp"
#include "verdigris/io/write_cells.hpp"

namespace verdigris {

namespace {

// [coat] names of letters and digits, for VTK and tables: each once, and none that stands for something else.
std::vector<std::string> plain_names(const CoatedMetal& metal) {
  std::vector<std::string> names{"metal_lost", "metal_left", "mean_loss", "greatest_loss",
                                 "added",      "removed",    "metal"};
  const auto taken = static_cast<std::ptrdiff_t>(names.size());
  for (const Coat& coat : metal.coats) {
    std::string plain;
    for (const char c : coat.layer.name) plain += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    std::string name = plain;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = fmt::format("{}_{}", plain, number);
    names.push_back(name);
  }
  names.erase(names.begin(), names.begin() + taken);
  return names;
}

}  // namespace

void write_timeline_csv(const std::filesystem::path& target, std::span<const TimelineRecord> records,
                        const CoatedMetal& metal, std::uint64_t cells) {
  ReplaceFile file(target);
  file.write(
      "operation,op,years,cells,added_um,removed_um,metal_um,bare_share,corroded_share,gone_share,"
      "damaged_share,mean_loss_um,greatest_loss_um,mass_loss_g_m2");
  for (const std::string& name : plain_names(metal)) file.write(fmt::format(",{}_um", name));
  file.write("\n");
  const double per_cell = 1.0 / std::max(1.0, static_cast<double>(cells));
  for (std::size_t k = 0; k < records.size(); ++k) {
    const TimelineRecord& r = records[k];
    const CoatedNumbers& n = r.numbers;
    file.write(fmt::format(
        "{},{},{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},"
        "{:.9g}",
        k + 1, r.op, r.years, r.report.cells, r.report.added * per_cell, r.report.removed * per_cell,
        r.report.metal * per_cell, n.bare, n.corroded, n.gone, n.damaged, n.loss, n.deepest, n.mass_loss));
    for (std::size_t c = 0; c < metal.coats.size(); ++c)
      file.write(fmt::format(",{:.9g}", c < n.coats.size() ? n.coats[c] : 0.0));
    file.write("\n");
  }
  file.commit();
}

void write_weathered_cells(const std::filesystem::path& file, const Surface& surface,
                           const CoatedMetal& metal) {
  Field<float> left(metal.loss.size());
  for (std::size_t slot = 0; slot < left.size(); ++slot)
    left[slot] = static_cast<float>(metal.metal.thickness) - metal.loss[slot];
  std::vector<CellArray> arrays{{"metal_lost_um", &metal.loss},
                                {"metal_left_um", &left},
                                {"corroded_years", &metal.corroded},
                                {"damage", &metal.damage}};
  const std::vector<std::string> names = plain_names(metal);
  for (std::size_t k = 0; k < metal.coats.size(); ++k) {
    const Coat& coat = metal.coats[k];
    arrays.push_back({names[k] + "_um", &coat.thickness});
    if (coat.kind == CoatKind::applied && !coat.adhesion.empty())
      arrays.push_back({names[k] + "_adhesion", &coat.adhesion});
  }
  write_cells_vtp(file, surface, arrays);
}

}  // namespace verdigris
