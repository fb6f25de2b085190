#include "verdigris/io/write_cells.hpp"

#include <fmt/format.h>

#include <limits>

#include "verdigris/io/replace_file.hpp"

namespace verdigris {

namespace {

// VTK's appended arrays: each is its length in bytes (UInt64), then the values.
struct Appended {
  std::string xml;
  std::uint64_t offset = 0;

  std::string array(const char* type, const std::string& name, int components, std::uint64_t bytes) {
    std::string text = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type, name, components, offset);
    offset += sizeof(std::uint64_t) + bytes;
    return text;
  }
};

void write_size(ReplaceFile& file, std::uint64_t bytes) {
  file.write(&bytes, sizeof bytes);
}

template <typename T, typename Value>
void write_values(ReplaceFile& file, const Surface& surface, Value&& value) {
  write_size(file, surface.owned_count() * sizeof(T));
  std::vector<T> row;
  for (std::uint32_t patch = 0; patch < surface.patch_count(); ++patch)
    for (std::uint32_t r = surface.row_begin(patch); r < surface.row_end(patch); ++r) {
      row.clear();
      const SlotRun run = surface.owned(r);
      for (std::uint32_t slot = run.begin; slot < run.end; ++slot) row.push_back(value(patch, r, slot));
      file.write(row.data(), row.size() * sizeof(T));
    }
}

template <typename Index>
void write_counting(ReplaceFile& file, std::uint64_t count, Index from) {
  write_size(file, count * sizeof(Index));
  std::vector<Index> block;
  for (std::uint64_t k = 0; k < count; ++k) {
    block.push_back(static_cast<Index>(k) + from);
    if (block.size() == 65536 || k + 1 == count) {
      file.write(block.data(), block.size() * sizeof(Index));
      block.clear();
    }
  }
}

}  // namespace

void write_cells_vtp(const std::filesystem::path& target, const Surface& surface,
                     std::span<const CellArray> arrays) {
  const std::uint64_t n = surface.owned_count();
  const bool wide = n > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
  const char* index_type = wide ? "Int64" : "Int32";
  const std::uint64_t index_bytes = n * (wide ? 8 : 4);

  Appended layout;
  std::string point_data;
  for (const CellArray& array : arrays)
    point_data += layout.array(array.values.index() == 0 ? "Int32" : "Float32", array.name, 1, 4 * n);
  point_data += layout.array("Int32", "patch", 1, 4 * n);
  point_data += layout.array("Float64", "area", 1, 8 * n);
  const std::string points = layout.array("Float64", "Points", 3, 24 * n);
  const std::string connectivity = layout.array(index_type, "connectivity", 1, index_bytes);
  const std::string offsets = layout.array(index_type, "offsets", 1, index_bytes);

  ReplaceFile file(target);
  file.write(fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
      "<PointData>\n{1}</PointData>\n<Points>\n{2}</Points>\n<Verts>\n{3}{4}</Verts>\n"
      "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_",
      n, point_data, points, connectivity, offsets));
  for (const CellArray& array : arrays)
    std::visit(
        [&](const auto* values) {
          using Value = typename std::decay_t<decltype(*values)>::value_type;
          write_values<Value>(file, surface, [&](std::uint32_t, std::uint32_t, std::uint32_t slot) {
            return (*values)[slot];
          });
        },
        array.values);
  write_values<std::int32_t>(file, surface, [](std::uint32_t patch, std::uint32_t, std::uint32_t) {
    return static_cast<std::int32_t>(patch);
  });
  const double area = surface.cell_size() * surface.cell_size();
  write_values<double>(file, surface, [&](std::uint32_t, std::uint32_t, std::uint32_t) { return area; });
  write_values<glm::dvec3>(file, surface, [&](std::uint32_t patch, std::uint32_t r, std::uint32_t slot) {
    const auto column = static_cast<std::int32_t>(slot - surface.rows()[r].base);
    return surface.frame(patch).to_model(surface.centre(surface.grid_row(patch, r), column));
  });
  static_assert(sizeof(glm::dvec3) == 24);
  if (wide) {
    write_counting<std::int64_t>(file, n, 0);
    write_counting<std::int64_t>(file, n, 1);
  } else {
    write_counting<std::int32_t>(file, n, 0);
    write_counting<std::int32_t>(file, n, 1);
  }
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

std::vector<Region> measure_regions(const Surface& surface, const Field<std::int32_t>& labels,
                                    std::size_t count) {
  std::vector<Region> regions(count);
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r) {
    const SlotRun run = surface.owned(r);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot)
      if (labels[slot] >= 0) ++regions[static_cast<std::size_t>(labels[slot])].cells;
  }
  for (Region& region : regions) {
    region.area = static_cast<double>(region.cells) * surface.cell_size() * surface.cell_size();
    region.share = static_cast<double>(region.cells) / static_cast<double>(surface.owned_count());
  }
  return regions;
}

std::vector<std::uint64_t> arrival_curve(const Surface& surface, const Field<std::int32_t>& arrivals) {
  std::vector<std::uint64_t> reached(1, 0);
  for (std::uint32_t r = 0; r < surface.rows().size(); ++r) {
    const SlotRun run = surface.owned(r);
    for (std::uint32_t slot = run.begin; slot < run.end; ++slot) {
      if (arrivals[slot] < 0) continue;
      const auto step = static_cast<std::size_t>(arrivals[slot]);
      if (step >= reached.size()) reached.resize(step + 1, 0);
      ++reached[step];
    }
  }
  return reached;
}

void write_regions_csv(const std::filesystem::path& target, std::span<const Region> regions,
                       std::span<const glm::dvec3> seed_positions) {
  ReplaceFile file(target);
  file.write("label,seed_x,seed_y,seed_z,cells,area,share\n");
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const glm::dvec3& p = seed_positions[k];
    file.write(fmt::format("{},{:.9g},{:.9g},{:.9g},{},{:.9g},{:.9g}\n", k, p.x, p.y, p.z, regions[k].cells,
                           regions[k].area, regions[k].share));
  }
  file.commit();
}

void write_curve_csv(const std::filesystem::path& target, std::span<const std::uint64_t> changed,
                     std::uint64_t cells) {
  ReplaceFile file(target);
  file.write("step,changed,filled_share\n");
  std::uint64_t filled = 0;
  for (std::size_t step = 0; step < changed.size(); ++step) {
    filled += changed[step];
    file.write(fmt::format("{},{},{:.9g}\n", step, changed[step],
                           static_cast<double>(filled) / static_cast<double>(cells)));
  }
  file.commit();
}

}  // namespace verdigris
