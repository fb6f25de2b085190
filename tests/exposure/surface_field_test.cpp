// Scalar fields on surfaces: where the model lies in them, no seams, any number of threads.

#include "verdigris/exposure/surface_field.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <filesystem>

#include "verdigris/io/read_mesh.hpp"
#include "verdigris/synthesis/builtin.hpp"

namespace verdigris {
namespace {

struct Along final : ScalarField {
  ValueRange range() const override { return {}; }
  void compute(const Points& p, double, std::span<float> out) const override {
    for (std::size_t k = 0; k < p.size(); ++k) out[k] = static_cast<float>(p.x[k]);
  }
};

Surface cube() {
  const Mesh mesh = read_mesh(std::filesystem::path(VERDIGRIS_MESHES) / "cube.obj");
  return make_surface(mesh, {.cell_size = cell_size_for(mesh, 20000)});
}

TEST(SurfaceField, LaysTheModelIntoTheWindow) {
  const Surface surface = cube();
  for (const double scale : {1.0, 3.0}) {
    const Field<float> field = field_on_surface(surface, Along(), {scale});
    float least = 1e9f, greatest = -1e9f;
    for (std::uint32_t r = 0; r < surface.rows().size(); ++r)
      for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; ++slot)
        least = std::min(least, field[slot]), greatest = std::max(greatest, field[slot]);
    EXPECT_NEAR(least, 0.5 - 0.5 * scale, 0.03 * scale);
    EXPECT_NEAR(greatest, 0.5 + 0.5 * scale, 0.03 * scale);
  }
}

TEST(SurfaceField, IsWhatTheFieldSaysAtTheCells) {
  const Surface surface = cube();
  const auto fbm = builtin_primitives().find("fbm").create({{"octaves", 2.0}}, 1);
  const Field<float> field = field_on_surface(surface, *fbm);
  const Bounds bounds = mesh_bounds(surface.mesh());
  const double side = bounds.upper.x - bounds.lower.x;
  for (std::uint32_t r = 0; r < surface.rows().size(); r += 7)
    for (std::uint32_t slot = surface.owned(r).begin; slot < surface.owned(r).end; slot += 5) {
      const glm::dvec3 p = (surface.position(slot) - bounds.lower) / side;
      ASSERT_NEAR(field[slot], fbm->at({p, 0.0}), 1e-6);
    }
}

TEST(SurfaceField, IsTheSameForAnyNumberOfThreads) {
  const Surface surface = cube();
  const auto fbm = builtin_primitives().find("hybrid").create({}, 1);
  Field<float> fields[2];
  for (const int k : {0, 1}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, k == 0 ? 1 : 4);
    fields[k] = field_on_surface(surface, *fbm);
  }
  EXPECT_EQ(fields[0], fields[1]);
}

}  // namespace
}  // namespace verdigris
