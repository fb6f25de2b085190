#include "verdigris/picture/camera.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <random>

#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

Mesh cloud(glm::dvec3 size, glm::dvec3 shift) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.5, 0.5);
  Mesh mesh;
  for (int k = 0; k < 500; ++k)
    mesh.positions.push_back(shift + size * glm::dvec3(unit(random), unit(random), unit(random)));
  return mesh;
}

TEST(Camera, EveryViewShowsAllAndFillsTheFrame) {
  const std::vector<Mesh> meshes{cloud({1, 1, 1}, {0, 0, 0}), cloud({10, 1, 0.1}, {1e6, -4e5, 3}),
                                 cloud({1e-3, 4e-3, 1e-3}, {1, 1, 1})};
  for (const Mesh& mesh : meshes)
    for (const UpAxis up : {UpAxis::y, UpAxis::z})
      for (const char* view : {"front", "back", "left", "right", "top", "bottom", "iso", "-1,2,0.5"})
        for (const int width : {640, 200}) {
          const Camera camera = frame_mesh(mesh, view, {up, 30.0, 0.05, width, 400});
          double x0 = 1e9, x1 = -1e9, y0 = 1e9, y1 = -1e9;
          for (const glm::dvec3& p : mesh.positions) {
            const glm::dvec3 pixel = camera.to_pixel(p);
            x0 = std::min(x0, pixel.x), x1 = std::max(x1, pixel.x);
            y0 = std::min(y0, pixel.y), y1 = std::max(y1, pixel.y);
            ASSERT_GT(pixel.z, 0.0);
            ASSERT_LT(pixel.z, 1.0);
          }
          // One pair of sides is touched at the margin, the other lies inside.
          const double across = (x1 - x0) / width, high = (y1 - y0) / 400;
          EXPECT_NEAR(std::max(across, high), 0.9, 1e-6) << view;
          EXPECT_GE(x0, 0.05 * width - 1e-3);
          EXPECT_LE(x1, 0.95 * width + 1e-3);
          EXPECT_GE(y0, 20.0 - 1e-3);
          EXPECT_LE(y1, 380.0 + 1e-3);
        }
}

TEST(Camera, NamedViewsLookTheRightWay) {
  EXPECT_EQ(view_direction("front"), glm::dvec3(0, 0, 1));
  EXPECT_EQ(view_direction("front", UpAxis::z), glm::dvec3(0, -1, 0));
  EXPECT_EQ(view_direction("top", UpAxis::z), glm::dvec3(0, 0, 1));
  EXPECT_EQ(view_direction("right"), glm::dvec3(1, 0, 0));
  EXPECT_NEAR(view_direction(" 0, 3,-4").y, 0.6, 1e-15);
  const Mesh mesh = cloud({1, 1, 1}, {0, 0, 0});
  const Camera front = frame_mesh(mesh, "front");  // x to the right, y up
  EXPECT_GT(front.to_pixel({0.5, 0, 0}).x, front.to_pixel({-0.5, 0, 0}).x);
  EXPECT_LT(front.to_pixel({0, 0.5, 0}).y, front.to_pixel({0, -0.5, 0}).y);
  const Camera top = frame_mesh(mesh, "top");  // the front of the model is at the bottom
  EXPECT_GT(top.to_pixel({0, 0, 0.5}).y, top.to_pixel({0, 0, -0.5}).y);
}

TEST(Camera, MatrixAgreesWithPixels) {
  const Mesh mesh = cloud({1, 2, 3}, {5, 6, 7});
  const Camera camera = frame_mesh(mesh, "iso");
  const glm::mat4 clip = camera.clip_from_model({5, 6, 7});
  for (const glm::dvec3& p : mesh.positions) {
    const glm::vec4 c = clip * glm::vec4(glm::vec3(p - glm::dvec3(5, 6, 7)), 1.0f);
    EXPECT_NEAR((c.x / c.w + 1.0f) * 0.5f * 1280.0f, camera.to_pixel(p).x, 1e-2);
  }
}

TEST(Camera, BadViewsAreRefused) {
  for (const char* view : {"", "fron", "1,2", "1,2,3,4", "0,0,0", "nan,1,1", "1;2;3"})
    EXPECT_THROW(view_direction(view), InputError) << view;
  EXPECT_THROW(frame_mesh(cloud({1, 1, 1}, {}), "front", {UpAxis::y, 30.0, 0.05, 0, 400}), InputError);
  EXPECT_THROW(frame_mesh(cloud({1, 1, 1}, {}), "front", {UpAxis::y, 180.0, 0.05, 10, 10}), InputError);
}

}  // namespace
}  // namespace verdigris
