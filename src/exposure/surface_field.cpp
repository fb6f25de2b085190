#include "verdigris/exposure/surface_field.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>

#include "verdigris/exposure/ghost_values.hpp"

namespace verdigris {

namespace {

double longest(const glm::dvec3& extent) {
  return std::max({extent.x, extent.y, extent.z});
}

// From model space into the field.
struct IntoField {
  glm::dvec3 model_middle, field_middle;
  double factor;

  glm::dvec3 operator()(const glm::dvec3& p) const { return field_middle + factor * (p - model_middle); }
};

IntoField place(const Surface& surface, const ScalarField& field, double scale) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  const Window window = field.window();
  const double size = longest(bounds.upper - bounds.lower);
  return {0.5 * (bounds.lower + bounds.upper), 0.5 * (window.lower + window.upper),
          size > 0.0 ? scale * longest(window.upper - window.lower) / size : scale};
}

}  // namespace

Field<float> field_on_surface(const Surface& surface, const ScalarField& field,
                              const FieldPlacement& placement) {
  const IntoField into = place(surface, field, placement.scale);
  const double footprint = into.factor * surface.cell_size();
  Field<float> values(surface.slot_count(), 0.0f);
  tbb::parallel_for(std::size_t{0}, surface.patch_count(), [&](std::size_t patch) {
    const Frame& frame = surface.frame(patch);
    std::vector<double> x, y, z;
    std::vector<std::uint32_t> slots;
    const auto flush = [&] {
      std::vector<float> found(slots.size());
      field.evaluate({x, y, z}, footprint, found);
      for (std::size_t k = 0; k < slots.size(); ++k) values[slots[k]] = found[k];
      x.clear(), y.clear(), z.clear(), slots.clear();
    };
    for (std::uint32_t r = surface.row_begin(patch); r < surface.row_end(patch); ++r) {
      const Row& row = surface.rows()[r];
      for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
        const auto column = static_cast<std::int32_t>(slot - row.base);
        const glm::dvec3 p = into(frame.to_model(surface.centre(surface.grid_row(patch, r), column)));
        x.push_back(p.x), y.push_back(p.y), z.push_back(p.z), slots.push_back(slot);
      }
      // Rows of small triangles are short: they are taken together.
      if (slots.size() >= 4096) flush();
    }
    flush();
  });
  copy_to_ghosts(surface, values);
  return values;
}

}  // namespace verdigris
