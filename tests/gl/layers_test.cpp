// The shader of layers against the CPU: the same colours to 1/255.
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "verdigris/gl/renderer.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/picture/colour.hpp"

namespace verdigris {
namespace {

Surface surface_of(Mesh mesh, double cells) {
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, cells);
  return make_surface(std::move(mesh), options);
}

std::array<int, 4> pixel(const Image& image, double x, double y) {
  const std::size_t k =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
  return {image.rgba[k], image.rgba[k + 1], image.rgba[k + 2], image.rgba[k + 3]};
}

LayerStack four_layers() {
  LayerStack stack;
  stack.layers = {crust_look({0.20f, 0.52f, 0.42f}, 0.9f, 0.6f, 4.0f),
                  crust_look({0.12f, 0.07f, 0.04f}, 0.3f, 0.2f),
                  crust_look({0.45f, 0.20f, 0.08f}, 0.6f, 0.0f, 2.0f),
                  crust_look({0.02f, 0.02f, 0.025f}, 0.1f, 0.9f, 20.0f)};
  stack.layers[0].far_colour = {0.40f, 0.62f, 0.55f};
  stack.substrate = metal_look({0.95f, 0.64f, 0.54f}, 0.2f);
  return stack;
}

// A sheet of 24 x 24 blocks of cells, each block with layers of its own; seen at a slant, so that light, eye
// and studio differ from block to block. Compared in the middle of each block.
void expect_light_of_the_cpu(int cells) {
  constexpr int blocks = 24;
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Surface surface = surface_of(mesh, blocks * cells * blocks * cells);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<LayerCell> of_block(blocks * blocks);
  for (LayerCell& cell : of_block) {
    for (auto& depth : cell.depth)
      depth = LayerCell::packed(unit(random) < 0.4f ? 0.0f : 3.0f * unit(random) * unit(random));
    cell.tint = static_cast<std::uint8_t>(255.0f * unit(random));
    cell.open = static_cast<std::uint8_t>(255.0f * unit(random));
    cell.present = unit(random) < 0.8f ? 255 : static_cast<std::uint8_t>(255.0f * unit(random));
  }
  const auto block_at = [&](glm::dvec3 p) {
    const auto at = [&](double x) { return std::clamp(static_cast<int>(x * blocks), 0, blocks - 1); };
    return static_cast<std::size_t>(at(p.y) * blocks + at(p.x));
  };
  std::vector<LayerCell> slots(surface.slot_count());
  for (std::uint32_t s = 2; s + 2 < slots.size(); ++s)  // guards stand at both ends
    slots[s] = of_block[block_at(surface.position(s))];

  const LayerStack stack = four_layers();
  RenderOptions options;
  options.samples = 1;
  SurfaceRenderer renderer(surface, options);
  for (const char* view : {"0.3,0.1,1", "-0.5,0.8,0.6", "0.1,-0.9,0.7"}) {
    const Camera camera = frame_mesh(mesh, view, {UpAxis::y, 40.0, 0.05, 900, 900});
    const SceneLight light = place_light(options.light, camera);
    const SceneStudio studio = place_studio({}, camera);
    const Image image = renderer.draw(LayerPicture{slots, stack}, camera);
    int worst = 0, different = 0;
    for (int k = 0; k < blocks * blocks; ++k) {
      const glm::dvec3 middle((k % blocks + 0.5) / blocks, (k / blocks + 0.5) / blocks, 0.0);
      const glm::dvec3 at = camera.to_pixel(middle);
      // The point seen through the middle of the pixel.
      const double px = (2.0 * (std::floor(at.x) + 0.5) / 900 - 1.0) * camera.tangent,
                   py = (1.0 - 2.0 * (std::floor(at.y) + 0.5) / 900) * camera.tangent;
      const glm::dvec3 ray = px * camera.right() + py * camera.up() - camera.backward();
      const glm::dvec3 p = camera.eye - camera.eye.z / ray.z * ray;
      const glm::vec3 colour = lit_cell(stack, of_block[block_at(middle)], light, studio, {0, 0, 1},
                                        glm::vec3(glm::normalize(camera.eye - p)));
      const Rgba8 expected = from_linear(colour);
      const std::array<int, 4> drawn = pixel(image, at.x, at.y);
      const int off = std::max({std::abs(drawn[0] - expected.r), std::abs(drawn[1] - expected.g),
                                std::abs(drawn[2] - expected.b)});
      worst = std::max(worst, off);
      different += off > 0;
    }
    EXPECT_LE(worst, 1) << view;
    EXPECT_LT(different, blocks * blocks / 4) << view;
  }
}

// Large on the screen cells are lit at every pixel, small ones at their centres.
TEST(LayerShader, IsTheLightOfTheCpuCellByCell) {
  expect_light_of_the_cpu(3);
  expect_light_of_the_cpu(7);
}

// Every normal there is: a sphere of one layer, from bare metal to a thick crust.
TEST(LayerShader, IsTheLightOfTheCpuOnASphere) {
  const Surface surface = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 60000.0);
  const LayerStack stack = four_layers();
  RenderOptions options;
  options.samples = 1;
  options.crease_angle = 180.0;
  SurfaceRenderer renderer(surface, options);
  const Camera camera = frame_mesh(surface.mesh(), "iso", {UpAxis::y, 30.0, 0.1, 400, 400});
  const SceneLight light = place_light(options.light, camera);
  const SceneStudio studio = place_studio({}, camera);
  for (const float depth : {0.0f, 0.05f, 0.8f, 12.0f}) {
    LayerCell cell;
    cell.depth[0] = LayerCell::packed(depth);
    const Image image =
        renderer.draw(LayerPicture{std::vector<LayerCell>(surface.slot_count(), cell), stack}, camera);
    double sum = 0.0;
    int count = 0;
    for (int y = 60; y < 340; y += 5)
      for (int x = 60; x < 340; x += 5) {
        const double px = (2.0 * (x + 0.5) / 400 - 1.0) * camera.tangent,
                     py = (1.0 - 2.0 * (y + 0.5) / 400) * camera.tangent;
        const glm::dvec3 ray = glm::normalize(px * camera.right() + py * camera.up() - camera.backward());
        const double b = glm::dot(camera.eye, ray), d = b * b - glm::dot(camera.eye, camera.eye) + 1.0;
        if (d < 0.15) continue;
        const glm::vec3 p(glm::normalize(camera.eye + (-b - std::sqrt(d)) * ray));
        const Rgba8 expected = from_linear(lit_cell(stack, cell, light, studio, p, glm::vec3(-ray)));
        const std::array<int, 4> drawn = pixel(image, x, y);
        // The normals of 1280 triangles are not those of the sphere: it is the mean that must agree.
        sum += std::abs(drawn[0] - expected.r) + std::abs(drawn[1] - expected.g) +
               std::abs(drawn[2] - expected.b);
        count += 3;
      }
    EXPECT_LT(sum / count, 2.5) << depth;
  }
}

TEST(LayerShader, AbsentMetalIsAHoleOrSomethingElse) {
  const Surface surface = surface_of(read_mesh(VERDIGRIS_MESHES "/cube.obj"), 2000.0);
  RenderOptions options;
  options.background_top = options.background_bottom = {0, 0, 0, 0};
  const Camera camera = frame_mesh(surface.mesh(), "front", {UpAxis::y, 30.0, 0.1, 160, 120});
  const LayerStack stack;
  LayerCell gone;
  gone.present = 0;
  const std::vector<LayerCell> cells(surface.slot_count(), gone);
  SurfaceRenderer renderer(surface, options);
  LayerPicture picture{cells, stack};
  EXPECT_EQ(pixel(renderer.draw(picture, camera), 80, 60)[3], 255);
  picture.holes = true;
  EXPECT_EQ(pixel(renderer.draw(picture, camera), 80, 60)[3], 0);
}

TEST(LayerShader, AReliefIsSeenAndLeavesTheNextPictureAlone) {
  const Surface surface = surface_of(read_mesh(VERDIGRIS_MESHES "/sphere.obj"), 20000.0);
  RenderOptions options;
  options.relief = true;
  options.background_top = options.background_bottom = {0, 0, 0, 0};
  const Camera camera = frame_mesh(surface.mesh(), "front", {UpAxis::y, 30.0, 0.2, 200, 200});
  const LayerStack stack;
  const std::vector<LayerCell> cells(surface.slot_count());
  const ReliefMaker make(surface);
  const Relief grown = make(std::vector<float>(surface.slot_count(), 0.1f));
  const auto covered = [](const Image& image) {
    int count = 0;
    for (std::size_t k = 3; k < image.rgba.size(); k += 4) count += image.rgba[k] > 127;
    return std::sqrt(count);
  };
  SurfaceRenderer renderer(surface, options);
  LayerPicture picture{cells, stack};
  const Image before = renderer.draw(picture, camera);
  picture.relief = &grown;
  const Image raised = renderer.draw(picture, camera);
  picture.relief = nullptr;
  EXPECT_EQ(renderer.draw(picture, camera).rgba, before.rgba);
  EXPECT_NEAR(covered(raised) / covered(before), 1.1, 0.01);
}

}  // namespace
}  // namespace verdigris
