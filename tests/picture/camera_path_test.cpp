// Cameras that move.
#include "verdigris/picture/camera_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

// A slab of 4 x 1 x 2 about (10, 0, 0).
Mesh slab() {
  Mesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.positions.emplace_back(10.0 + ((k & 1) != 0 ? 2.0 : -2.0), (k & 2) != 0 ? 0.5 : -0.5,
                                (k & 4) != 0 ? 1.0 : -1.0);
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}};
  return mesh;
}

TEST(CameraPath, OfOneViewIsTheCameraOfStills) {
  const Mesh mesh = slab();
  const ViewSettings settings;
  const CameraPath path(mesh, {{0.0, {1, 1, 1}, 1.0, {}}}, 0.0, settings);
  const Camera still = frame_mesh(mesh, glm::dvec3(1, 1, 1), settings);
  for (const double share : {0.0, 0.4, 1.0}) EXPECT_EQ(path.at(share).eye, still.eye);
}

TEST(CameraPath, TurnsRoundTheMiddleAndKeepsTheModelInThePicture) {
  const Mesh mesh = slab();
  for (const UpAxis up : {UpAxis::y, UpAxis::z}) {
    ViewSettings settings;
    settings.up = up;
    const CameraPath path(mesh, {{0.0, view_direction("iso", up), 1.0, {}}}, 360.0, settings);
    const glm::dvec3 middle(10, 0, 0), axis = up == UpAxis::y ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    const Camera first = path.at(0.0), last = path.at(1.0);
    EXPECT_NEAR(glm::distance(first.eye, last.eye), 0.0, 1e-9);
    EXPECT_NEAR(glm::dot(first.backward(), view_direction("iso", up)), 1.0, 1e-12);
    double closest = 1e9;
    for (int k = 0; k <= 96; ++k) {
      const Camera camera = path.at(k / 96.0);
      EXPECT_NEAR(glm::distance(camera.eye, middle), glm::distance(first.eye, middle), 1e-9);
      EXPECT_NEAR(glm::dot(camera.eye - middle, axis), glm::dot(first.eye - middle, axis), 1e-9);
      for (const glm::dvec3& p : mesh.positions) {
        const glm::dvec3 pixel = camera.to_pixel(p);
        closest = std::min({closest, pixel.x, pixel.y, camera.width - pixel.x, camera.height - pixel.y});
        EXPECT_GT(pixel.z, 0.0);
        EXPECT_LT(pixel.z, 1.0);
      }
    }
    // The margin is kept, and touched.
    EXPECT_NEAR(closest, 0.04 * 960, 16.0);
  }
}

TEST(CameraPath, SeesAllSidesOnManyTurns) {
  const Mesh mesh = slab();
  // 96 turns: at every 96th of the film the same side.
  const CameraPath path(mesh, {{0.0, {1, 0, 0}, 1.0, {}}}, 96.0 * 360.0, {});
  double closest = 1e9;
  for (int k = 0; k <= 997; ++k) {
    const Camera camera = path.at(k / 997.0);
    for (const glm::dvec3& p : mesh.positions) {
      const glm::dvec3 pixel = camera.to_pixel(p);
      closest = std::min({closest, pixel.x, pixel.y, camera.width - pixel.x, camera.height - pixel.y});
    }
  }
  EXPECT_GT(closest, 30.0);
}

TEST(CameraPath, PassesItsViewsWithoutAJerk) {
  const Mesh mesh = slab();
  const std::vector<CameraKey> keys{{0.0, {0.2, 0, -1}, 1.0, {}},
                                    {0.3, {-1, 1, -1}, 2.0, {}},
                                    {1.0, {-1, 0.2, 1}, 4.0, glm::dvec3(12, 0.5, 1)}};
  const CameraPath path(mesh, keys, 0.0, {});
  for (const CameraKey& key : keys)
    EXPECT_NEAR(glm::dot(path.at(key.at).backward(), glm::normalize(key.direction)), 1.0, 1e-9);
  const glm::dvec3 end = path.at(1.0).eye - glm::dvec3(12, 0.5, 1),
                   begin = path.at(0.0).eye - glm::dvec3(10, 0, 0);
  EXPECT_NEAR(glm::length(begin) / glm::length(end), 4.0, 1e-9);
  // The shorter way round, and no step much longer than its neighbours.
  double total = 0.0, last_step = 0.0;
  for (int k = 1; k <= 1000; ++k) {
    const double step = std::acos(
        std::min(1.0, glm::dot(path.at((k - 1) / 1000.0).backward(), path.at(k / 1000.0).backward())));
    EXPECT_LT(std::abs(step - last_step), 2e-4);
    last_step = step;
    total += step;
  }
  EXPECT_LT(total, 3.2);
}

TEST(CameraPath, RefusesWhatIsNoWay) {
  const Mesh mesh = slab();
  EXPECT_THROW(CameraPath(mesh, {}, 90.0, {}), InputError);
  EXPECT_THROW(CameraPath(mesh, {{0.5, {0, 0, 1}, 1.0, {}}, {0.5, {1, 0, 1}, 1.0, {}}}, 0.0, {}), InputError);
  EXPECT_THROW(CameraPath(mesh, {{0.0, {0, 0, 1}, 0.0, {}}}, 0.0, {}), InputError);
}

}  // namespace
}  // namespace verdigris
