#include "verdigris/exposure/surface_field.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <vector>

#include "verdigris/surface/ghost_values.hpp"

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
  // Cells of many triangles are taken together: small ones have a few each, and a field works on batches.
  constexpr std::size_t batch = 4096;
  const std::size_t grain = std::clamp<std::size_t>(
      batch * surface.patch_count() / std::max<std::size_t>(1, surface.slot_count()), 1, 64);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, surface.patch_count(), grain),
                    [&](const tbb::blocked_range<std::size_t>& patches) {
                      std::vector<double> x, y, z;
                      std::vector<std::uint32_t> slots;
                      std::vector<float> found;
                      const auto flush = [&] {
                        found.resize(slots.size());
                        field.evaluate({x, y, z}, footprint, found);
                        for (std::size_t k = 0; k < slots.size(); ++k) values[slots[k]] = found[k];
                        x.clear(), y.clear(), z.clear(), slots.clear();
                      };
                      for (std::size_t patch = patches.begin(); patch < patches.end(); ++patch) {
                        const Frame& frame = surface.frame(patch);
                        for (std::uint32_t r = surface.row_begin(patch); r < surface.row_end(patch); ++r) {
                          const Row& row = surface.rows()[r];
                          for (std::uint32_t slot = row.run_begin; slot < row.run_end; ++slot) {
                            const auto column = static_cast<std::int32_t>(slot - row.base);
                            const glm::dvec3 p =
                                into(frame.to_model(surface.centre(surface.grid_row(patch, r), column)));
                            x.push_back(p.x), y.push_back(p.y), z.push_back(p.z), slots.push_back(slot);
                          }
                          if (slots.size() >= batch) flush();
                        }
                      }
                      flush();
                    });
  copy_to_ghosts(surface, values);
  return values;
}

}  // namespace verdigris
