#include "verdigris/gl/renderer.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

#include "buffers.hpp"
#include "layer_program.hpp"
#include "shaders.hpp"
#include "target.hpp"
#include "verdigris/gl/offscreen_context.hpp"
#include "verdigris/picture/normals.hpp"

namespace verdigris {

namespace {

constexpr std::size_t flight_bytes = std::size_t{32} << 20;

// A range of the surface on its way to the screen.
struct Chunk {
  BandRange range;
  BandMesh bands;  // without what has gone to the driver for good
  std::vector<std::uint32_t> triangles;
  std::vector<Rgba8> colours;
  std::vector<LayerCell> cells;
  std::vector<glm::vec3> positions;  // relieved
  std::vector<PackedNormal> normals;
  std::size_t vertices = 0;
  std::optional<gl::Buffers> kept;

  explicit Chunk(const BandRange& r) : range(r) {}
};

BandBuilder make_builder(const Surface& s, const RenderOptions& o) {
  return {s, corner_normals(s.mesh(), s.adjacency(), o.crease_angle),
          o.relief ? relief_directions(s.mesh()) : std::vector<glm::vec3>()};
}

// Every piece is closed and its triangles look outwards: those seen from behind are hidden.
bool is_solid(const Mesh& mesh, const Adjacency& adjacency) {
  if (std::find(adjacency.opposite.begin(), adjacency.opposite.end(), Adjacency::none) !=
      adjacency.opposite.end())
    return false;
  const glm::dvec3 middle = mesh.positions.empty() ? glm::dvec3(0.0) : mesh.positions[0];
  std::vector<bool> seen(mesh.triangles.size(), false);
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < seen.size(); ++first) {
    if (seen[first]) continue;
    double volume = 0.0;
    seen[first] = true;
    for (open.assign(1, first); !open.empty();) {
      const std::uint32_t t = open.back();
      open.pop_back();
      volume += glm::dot(mesh.corner(t, 0) - middle,
                         glm::cross(mesh.corner(t, 1) - middle, mesh.corner(t, 2) - middle));
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = adjacency.opposite[3 * t + k] / 3;
        if (seen[across]) continue;
        seen[across] = true;
        open.push_back(across);
      }
    }
    if (volume <= 0.0) return false;
  }
  return true;
}

// Cells of a surface that are smaller than this on the screen are lit at their centres only.
constexpr double fine_pixels = 6.0;

// The side of a cell in pixels where the model is nearest to the eye.
double pixels_a_cell(const Surface& surface, const Camera& camera, glm::dvec3 origin) {
  const Bounds bounds = mesh_bounds(surface.mesh());
  const double distance = glm::distance(camera.eye, origin) - 0.5 * glm::distance(bounds.lower, bounds.upper);
  return surface.cell_size() * camera.height / (2.0 * camera.tangent * std::max(distance, camera.near));
}

}  // namespace

struct SurfaceRenderer::State {
  OffscreenContext context;  // first: everything else in here is deleted while it lives
  RenderOptions options;
  BandBuilder builder;
  gl::Program surface = gl::surface_program(), background = gl::background_program();
  std::array<std::optional<gl::Program>, 2> layers;  // coarse, fine
  bool solid;
  gl::VertexArray nothing;
  gl::Buffers passing;
  std::optional<gl::Target> target;
  std::vector<Chunk> chunks;
  std::size_t cached = 0, in_flight = 0;

  State(const Surface& s, const RenderOptions& o)
      : options(o), builder(make_builder(s, o)), solid(is_solid(s.mesh(), s.adjacency())) {
    for (const BandRange& range : band_ranges(s, o.chunk_slots)) chunks.emplace_back(range);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { context.make_current(); }

  void begin(const Camera& camera);
  void draw_background() const;
  void set_uniforms(GLuint program, const Camera& camera) const;
  void build(Chunk& chunk) const;
  void draw_chunk(Chunk& chunk);
  template <typename Prepare>
  void draw_chunks(const Prepare& prepare);
};

void SurfaceRenderer::State::begin(const Camera& camera) {
  context.make_current();
  const int factor = std::clamp(options.supersampling, 1, 4);
  if (!target || target->width() != camera.width || target->height() != camera.height) {
    target.reset();
    target.emplace(camera.width, camera.height, factor, options.samples);
  }
  target->bind();
  glEnable(GL_MULTISAMPLE);
  glDisable(GL_DEPTH_TEST);
  draw_background();
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  // A relief may fold over itself at its steepest: its inner side is better than the background.
  const Bounds bounds = mesh_bounds(builder.surface().mesh());
  const bool within =
      glm::all(glm::lessThan(bounds.lower, camera.eye)) && glm::all(glm::lessThan(camera.eye, bounds.upper));
  (solid && !within && !options.relief ? glEnable : glDisable)(GL_CULL_FACE);
  glPrimitiveRestartIndex(BandIndices::restart);
}

void SurfaceRenderer::State::draw_background() const {
  glUseProgram(background);
  const auto set = [&](const char* name, Rgba8 colour) {
    const glm::vec3 c = to_linear(colour);
    glUniform4f(glGetUniformLocation(background, name), c.r, c.g, c.b, static_cast<float>(colour.a) / 255.0f);
  };
  set("top", options.background_top);
  set("bottom", options.background_bottom);
  glBindVertexArray(nothing);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SurfaceRenderer::State::set_uniforms(GLuint program, const Camera& camera) const {
  const SceneLight light = place_light(options.light, camera);
  const glm::mat4 clip = camera.clip_from_model(builder.origin());
  const glm::vec3 eye(camera.eye - builder.origin());
  const auto location = [&](const char* name) { return glGetUniformLocation(program, name); };
  glUseProgram(program);
  glUniformMatrix4fv(location("clip"), 1, GL_FALSE, glm::value_ptr(clip));
  glUniform3fv(location("eye"), 1, glm::value_ptr(eye));
  glUniform3fv(location("towards"), 2, glm::value_ptr(light.towards[0]));
  glUniform1fv(location("strength"), 2, light.strength.data());
}

// The part of the work that needs no OpenGL, for any thread.
void SurfaceRenderer::State::build(Chunk& chunk) const {
  if (chunk.kept) return;
  chunk.bands = builder.build(chunk.range);
  chunk.vertices = chunk.bands.positions.size();
  chunk.triangles = triangles_of(chunk.bands.indices);
  chunk.bands.indices = {};
}

void SurfaceRenderer::State::draw_chunk(Chunk& chunk) {
  in_flight += sizeof(Rgba8) * chunk.colours.size() + sizeof(LayerCell) * chunk.cells.size() +
               (sizeof(glm::vec3) + sizeof(PackedNormal)) * chunk.positions.size();
  if (!chunk.kept) in_flight += chunk.bands.bytes() + sizeof(std::uint32_t) * chunk.triangles.size();
  gl::Buffers* buffers = chunk.kept ? &*chunk.kept : &passing;
  const std::size_t bytes = chunk.bands.bytes() + 4 * (chunk.vertices + chunk.triangles.size());
  if (!chunk.kept && cached + bytes <= options.cache_bytes) {
    cached += bytes;
    buffers = &chunk.kept.emplace();
    buffers->upload(chunk.bands, chunk.triangles, GL_STATIC_DRAW);
    if (!options.relief) {
      chunk.bands.positions = {};
      chunk.bands.normals = {};
    }
  } else if (!chunk.kept) {
    buffers->upload(chunk.bands, chunk.triangles, GL_STREAM_DRAW);
  }
  if (!chunk.positions.empty())
    buffers->place(chunk.positions, chunk.normals, GL_STREAM_DRAW);
  else if (options.relief && chunk.kept)
    buffers->place(chunk.bands.positions, chunk.bands.normals, GL_STREAM_DRAW);
  if (chunk.cells.empty())
    buffers->draw(chunk.colours);
  else
    buffers->draw(chunk.cells);
  if (!chunk.kept) chunk.bands = {};
  chunk.colours = {};
  chunk.cells = {};
  chunk.positions = {};
  chunk.normals = {};
  chunk.triangles = {};
}

// `prepare(chunk)` runs on any thread, after the chunk's geometry is there.
template <typename Prepare>
void SurfaceRenderer::State::draw_chunks(const Prepare& prepare) {
  // A few chunks a thread are made at a time; so many, not all of them, are in memory.
  const auto wave = static_cast<std::size_t>(2 * tbb::this_task_arena::max_concurrency());
  for (std::size_t first = 0; first < chunks.size(); first += wave) {
    const std::size_t last = std::min(first + wave, chunks.size());
    tbb::parallel_for(first, last, [&](std::size_t k) {
      build(chunks[k]);
      prepare(chunks[k]);
    });
    for (std::size_t k = first; k < last; ++k) draw_chunk(chunks[k]);
    // Or the driver keeps all that passes through until the picture is asked for. Not each time: Mesa's
    // software renderer then reads and writes the whole image once more.
    if (in_flight > flight_bytes) {
      glFinish();
      in_flight = 0;
    }
  }
}

SurfaceRenderer::SurfaceRenderer(const Surface& surface, const RenderOptions& options)
    : state_(std::make_unique<State>(surface, options)) {}
SurfaceRenderer::~SurfaceRenderer() = default;
SurfaceRenderer::SurfaceRenderer(SurfaceRenderer&&) noexcept = default;
SurfaceRenderer& SurfaceRenderer::operator=(SurfaceRenderer&&) noexcept = default;

std::string SurfaceRenderer::driver() const {
  return state_->context.renderer();
}

Image SurfaceRenderer::draw(std::span<const Rgba8> slot_colours, const Camera& camera) {
  State& s = *state_;
  assert(slot_colours.size() == s.builder.surface().slot_count());
  s.begin(camera);
  const auto absent = [](Rgba8 colour) { return colour.a < 255; };
  if (std::any_of(slot_colours.begin(), slot_colours.end(), absent)) glDisable(GL_CULL_FACE);
  s.set_uniforms(s.surface, camera);
  const LightSettings& light = s.options.light;
  glUniform4f(glGetUniformLocation(s.surface, "terms"), light.ambient, light.diffuse, light.specular,
              light.shininess);
  s.draw_chunks([&](Chunk& chunk) {
    chunk.colours.resize(chunk.vertices);
    colour_bands(chunk.bands, slot_colours, chunk.colours);
  });
  return s.target->resolve();
}

Image SurfaceRenderer::draw(const LayerPicture& picture, const Camera& camera) {
  State& s = *state_;
  assert(picture.cells.size() == s.builder.surface().slot_count());
  assert(picture.relief == nullptr || s.options.relief);
  s.begin(camera);
  const bool fine = pixels_a_cell(s.builder.surface(), camera, s.builder.origin()) > fine_pixels;
  std::optional<gl::Program>& program = s.layers[fine];
  if (!program) program = gl::layer_program(fine);
  s.set_uniforms(*program, camera);
  gl::set_layers(*program, picture.stack, place_studio(picture.studio, camera), picture.holes);
  if (picture.holes) glDisable(GL_CULL_FACE);
  s.draw_chunks([&](Chunk& chunk) {
    chunk.cells.resize(chunk.vertices);
    layer_bands(chunk.bands, picture.cells, chunk.cells);
    if (picture.relief == nullptr) return;
    chunk.positions.resize(chunk.vertices);
    chunk.normals.resize(chunk.vertices);
    relieve_bands(chunk.bands, *picture.relief, chunk.positions, chunk.normals);
  });
  return s.target->resolve();
}

Image render(const Surface& surface, std::span<const Rgba8> slot_colours, const Camera& camera,
             const RenderOptions& options) {
  return SurfaceRenderer(surface, options).draw(slot_colours, camera);
}

}  // namespace verdigris
