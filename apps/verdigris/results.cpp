#include "results.hpp"

#include <variant>

#include "picture.hpp"
#include "verdigris/io/write_cells.hpp"
#include "verdigris/surface/ghost_values.hpp"

using namespace verdigris;

Results write_results(const std::filesystem::path& out, const Surface& surface,
                      const AnySimulation& simulation, const PlacedSeeds& placed, std::span<const Mask> masks,
                      bool cells) {
  Results results;
  std::vector<std::variant<Field<std::int32_t>, Field<float>>> fields;
  for (const FieldInfo& info : simulation.fields()) {
    if (!cells && info.kind == FieldKind::quantity) continue;
    if (info.real)
      fields.emplace_back(simulation.real_field(info.name));
    else
      fields.emplace_back(simulation.field(info.name));
    if (info.kind == FieldKind::label) {
      const auto regions =
          measure_regions(surface, std::get<Field<std::int32_t>>(fields.back()), placed.seeds.size());
      std::vector<glm::dvec3> positions;
      for (const Seed& seed : placed.seeds) positions.push_back(surface.position(seed.slot));
      write_regions_csv(out / "regions.csv", regions, positions);
      results.files.push_back("regions.csv");
      results.unreached = surface.owned_count();
      for (const Region& region : regions) results.unreached -= region.cells;
    }
    if (info.kind == FieldKind::arrival) {
      const auto curve = arrival_curve(surface, std::get<Field<std::int32_t>>(fields.back()));
      write_curve_csv(out / "curve.csv", curve, surface.owned_count());
      results.files.push_back("curve.csv");
    }
  }
  if (cells) {
    std::vector<CellArray> arrays;
    for (std::size_t k = 0; k < fields.size(); ++k)
      std::visit(
          [&](const auto& field) {
            arrays.push_back({simulation.fields()[k].name, &field});
          },
          fields[k]);
    for (const Mask& mask : masks) arrays.push_back({"mask_" + mask.name, &mask.values});
    write_cells_vtp(out / "cells.vtp", surface, arrays);
    results.files.insert(results.files.begin(), "cells.vtp");
  }
  return results;
}

CellValues first_field(const AnySimulation& simulation) {
  const FieldInfo info = simulation.fields().front();
  if (info.real) return simulation.real_field(info.name);
  return simulation.field(info.name);
}

OpenView::OpenView(const Surface& surface, LinkKind links) : surface_(surface) {
  if (!surface.barred_edges().empty() && links != LinkKind::projected)
    open_.emplace(make_surface(surface.mesh(), {surface.cell_size(), links}));
}

CellValues OpenView::operator()(CellValues values) const {
  if (open_) std::visit([&](auto& field) { copy_to_ghosts(*open_, field); }, values);
  return values;
}

void draw_results(const std::filesystem::path& out, const Surface& surface, const AnySimulation& simulation,
                  const Scene& scene) {
  const bool labels = simulation.fields().front().kind == FieldKind::label;
  const std::filesystem::path file = out / "picture.png";
  const CellValues values = first_field(simulation);
  if (scene.torus.width != 0) return write_torus_picture(file, surface, values, labels, scene.torus);
  const OpenView view(surface, scene.links);
  write_picture(file, view.surface(), view(values), labels, scene.picture);
}

std::string draw_mask(const std::filesystem::path& out, const Surface& surface, const Mask& mask,
                      const Scene& scene) {
  const std::string name = "mask_" + mask.name + ".png";
  CellValues values = mask.values;
  if (scene.torus.width != 0)
    write_torus_picture(out / name, surface, values, false, scene.torus);
  else
    write_picture(out / name, surface, values, false, scene.picture);
  return name;
}
