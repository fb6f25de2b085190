// Pictures with known pixels. They differ a little between drivers, so everything is compared with a
// tolerance.
#include "verdigris/gl/renderer.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <numbers>

#include "verdigris/io/write_png.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {
namespace {

Mesh cube() {
  Mesh mesh;
  for (unsigned k = 0; k < 8; ++k) mesh.positions.emplace_back(k & 1, (k >> 1) & 1, k >> 2);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

Mesh sphere(int rings) {
  Mesh mesh;
  const int around = 2 * rings;
  mesh.positions.emplace_back(0, 1, 0);
  for (int r = 1; r < rings; ++r)
    for (int k = 0; k < around; ++k) {
      const double a = std::numbers::pi * r / rings, b = std::numbers::pi * k / rings;
      mesh.positions.emplace_back(std::sin(a) * std::sin(b), std::cos(a), std::sin(a) * std::cos(b));
    }
  mesh.positions.emplace_back(0, -1, 0);
  const auto at = [&](int r, int k) { return static_cast<std::uint32_t>(1 + (r - 1) * around + k % around); };
  const auto last = static_cast<std::uint32_t>(mesh.positions.size() - 1);
  for (int k = 0; k < around; ++k) {
    mesh.triangles.emplace_back(0, at(1, k), at(1, k + 1));
    for (int r = 1; r + 1 < rings; ++r) {
      mesh.triangles.emplace_back(at(r, k), at(r + 1, k), at(r + 1, k + 1));
      mesh.triangles.emplace_back(at(r, k), at(r + 1, k + 1), at(r, k + 1));
    }
    mesh.triangles.emplace_back(at(rings - 1, k), last, at(rings - 1, k + 1));
  }
  return mesh;
}

Surface surface_of(Mesh mesh, double cells) {
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, cells);
  return make_surface(std::move(mesh), options);
}

Rgba8 pixel(const Image& image, double x, double y) {
  const std::size_t k =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[k], image.rgba[k + 1], image.rgba[k + 2], image.rgba[k + 3]};
}

void expect_near(Rgba8 a, Rgba8 b, int tolerance) {
  EXPECT_LE(std::abs(a.r - b.r), tolerance) << int{a.r} << " for " << int{b.r};
  EXPECT_LE(std::abs(a.g - b.g), tolerance) << int{a.g} << " for " << int{b.g};
  EXPECT_LE(std::abs(a.b - b.b), tolerance) << int{a.b} << " for " << int{b.b};
  EXPECT_EQ(a.a, b.a);
}

ViewSettings small_view() {
  return {UpAxis::y, 30.0, 0.1, 320, 240};
}

TEST(Renderer, CubeHasTheColoursOfItsFaces) {
  const Surface surface = surface_of(cube(), 5000.0);
  const std::array<Rgba8, 6> faces{{{200, 60, 60, 255},
                                    {60, 200, 60, 255},
                                    {60, 60, 200, 255},
                                    {200, 200, 60, 255},
                                    {200, 60, 200, 255},
                                    {60, 200, 200, 255}}};
  std::vector<Rgba8> colours(surface.slot_count());
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t s = surface.rows()[row].begin; s < surface.rows()[row].run_end; ++s)
      colours[s] = faces[surface.patch_of_row(row) / 2];
  SurfaceRenderer renderer(surface);
  const Camera camera = frame_mesh(surface.mesh(), "iso", small_view());
  const SceneLight light = place_light({}, camera);
  const Image image = renderer.draw(colours, camera);
  // Off the diagonal, so that no contour point with a mean of two ghosts is near.
  struct Face {
    glm::dvec3 point;
    glm::vec3 normal;
    std::size_t number;
  };
  for (const Face& f : {Face{{0.3, 0.6, 1.0}, {0, 0, 1}, 1}, Face{{1.0, 0.6, 0.3}, {1, 0, 0}, 5},
                        Face{{0.3, 1.0, 0.6}, {0, 1, 0}, 3}}) {
    const glm::dvec3 at = camera.to_pixel(f.point);
    const glm::vec3 to_eye(glm::normalize(camera.eye - f.point));
    expect_near(pixel(image, at.x, at.y),
                from_linear(lit(light, f.normal, to_eye, to_linear(faces[f.number]))), 1);
  }
  // The second picture comes from kept buffers and must be the same; so must one that keeps nothing, in small
  // chunks.
  EXPECT_EQ(image.rgba, renderer.draw(colours, camera).rgba);
  RenderOptions streamed;
  streamed.cache_bytes = 0;
  streamed.chunk_slots = 300;
  const Image other = render(surface, colours, camera, streamed);
  std::size_t different = 0;
  for (std::size_t k = 0; k < image.rgba.size(); ++k)
    different += std::abs(image.rgba[k] - other.rgba[k]) > 1;
  EXPECT_EQ(different, 0u);
}

TEST(Renderer, LightOnASphereIsTheLightOfTheFormula) {
  const Surface surface = surface_of(sphere(96), 40000.0);
  const Rgba8 material{150, 120, 90, 255};
  const std::vector<Rgba8> colours(surface.slot_count(), material);
  const Camera camera = frame_mesh(surface.mesh(), "1,0.4,2", small_view());
  const SceneLight light = place_light({}, camera);
  const Image image = render(surface, colours, camera);
  for (int y = 40; y < 200; y += 8)
    for (int x = 80; x < 240; x += 8) {
      // The ray through the middle of the pixel against the unit sphere.
      const double px = (2.0 * (x + 0.5) / 320 - 1.0) * camera.tangent * 320 / 240,
                   py = (1.0 - 2.0 * (y + 0.5) / 240) * camera.tangent;
      const glm::dvec3 ray = glm::normalize(px * camera.right() + py * camera.up() - camera.backward());
      const double b = glm::dot(camera.eye, ray), d = b * b - glm::dot(camera.eye, camera.eye) + 1.0;
      if (d < 0.3) continue;
      const glm::dvec3 p = camera.eye + (-b - std::sqrt(d)) * ray;
      expect_near(pixel(image, x, y),
                  from_linear(lit(light, glm::vec3(p), glm::vec3(-ray), to_linear(material))), 1);
    }
}

TEST(Renderer, OpenMeshesAreSeenFromBehind) {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Surface surface = surface_of(mesh, 300.0);
  const std::vector<Rgba8> colours(surface.slot_count(), {90, 150, 140, 255});
  for (const char* view : {"front", "back"}) {
    const Image image = render(surface, colours, frame_mesh(mesh, view, small_view()));
    const Rgba8 c = pixel(image, 160, 120);
    EXPECT_GT(c.g, c.r + 20) << view;
    EXPECT_GT(c.g, 100) << view;
    expect_near(pixel(image, 2, 1), RenderOptions{}.background_top, 2);
  }
}

TEST(Renderer, NoBackgroundShowsThroughAClosedSurface) {
  // Red inside and nothing but red may be seen well inside the outline: a crack would show the white behind.
  const Surface surface = surface_of(sphere(40), 3000.0);
  const std::vector<Rgba8> colours(surface.slot_count(), {200, 0, 0, 255});
  for (const int factor : {1, 2}) {
    RenderOptions options;
    options.supersampling = factor;
    options.background_top = options.background_bottom = {0, 255, 0, 255};
    const Image image = render(surface, colours, frame_mesh(surface.mesh(), "iso", small_view()), options);
    int seen = 0;
    for (int y = 0; y < 240; ++y)
      for (int x = 0; x < 320; ++x)
        if (std::hypot(x - 159.5, y - 119.5) < 94.0) seen += pixel(image, x, y).g > 0;
    EXPECT_EQ(seen, 0);
  }
}

TEST(Renderer, HolesAndTransparentBackground) {
  const Surface surface = surface_of(cube(), 2000.0);
  RenderOptions options;
  options.background_top = options.background_bottom = {0, 0, 0, 0};
  const Camera camera = frame_mesh(surface.mesh(), "front", small_view());
  const Image gone =
      render(surface, std::vector<Rgba8>(surface.slot_count(), Rgba8{9, 9, 9, 0}), camera, options);
  EXPECT_EQ(pixel(gone, 160, 120).a, 0);
  const Image there =
      render(surface, std::vector<Rgba8>(surface.slot_count(), Rgba8{99, 99, 99, 255}), camera, options);
  EXPECT_EQ(pixel(there, 160, 120).a, 255);
  EXPECT_EQ(pixel(there, 1, 1).a, 0);
}

TEST(Renderer, TooLargeAPictureIsRefused) {
  const Surface surface = surface_of(cube(), 100.0);
  const std::vector<Rgba8> colours(surface.slot_count());
  EXPECT_THROW(
      render(surface, colours, frame_mesh(surface.mesh(), "iso", {UpAxis::y, 30.0, 0.04, 200000, 100})),
      InputError);
}

TEST(Png, SameImageSameBytesAndNoHalfFile) {
  const Image image{
      3, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255, 8, 8, 8, 255, 7, 7, 7, 128}};
  const auto folder = std::filesystem::path(testing::TempDir()) / "verdigris_png";
  std::filesystem::create_directories(folder);
  const auto bytes = [&](const char* name) {
    write_png(image, folder / name);
    std::ifstream in(folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string first = bytes("a.png");
  EXPECT_EQ(first, bytes("b.png"));
  EXPECT_EQ(first.substr(1, 3), "PNG");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 2);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(write_png(image, folder / "none" / "a.png"), InputError);
  EXPECT_THROW(write_png({}, std::filesystem::path(testing::TempDir()) / "empty.png"), InputError);
}

}  // namespace
}  // namespace verdigris
