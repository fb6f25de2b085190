#include "verdigris/gl/renderer.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "shaders.hpp"
#include "target.hpp"
#include "verdigris/gl/offscreen_context.hpp"
#include "verdigris/picture/normals.hpp"

namespace verdigris {

namespace {

template <class T>
void fill(GLenum target, GLuint buffer, const std::vector<T>& data, GLenum usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

// Strips and fans are taken apart before they are drawn: where patches hold few cells they are many and
// short, and Mesa's software renderer draws them one by one (bunny, 1M cells, 5.2M triangles: 2.6 s; 2.2 s as
// single triangles).
//
// The buffers of one chunk; filled once if it is kept, over and over if it is only passing through.
struct Buffers {
  gl::VertexArray array;
  gl::Buffer positions, normals, colours, triangles;
  GLsizei index_count = 0;

  void upload(const BandMesh& bands, const std::vector<std::uint32_t>& indices, GLenum usage) {
    glBindVertexArray(array);
    fill(GL_ARRAY_BUFFER, positions, bands.positions, usage);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    fill(GL_ARRAY_BUFFER, normals, bands.normals, usage);
    glVertexAttribPointer(1, 2, GL_SHORT, GL_TRUE, 0, nullptr);
    glBindBuffer(GL_ARRAY_BUFFER, colours);
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, nullptr);
    for (GLuint k = 0; k < 3; ++k) glEnableVertexAttribArray(k);
    fill(GL_ELEMENT_ARRAY_BUFFER, triangles, indices, usage);
    index_count = static_cast<GLsizei>(indices.size());
  }

  void draw(const std::vector<Rgba8>& vertex_colours) {
    glBindVertexArray(array);
    fill(GL_ARRAY_BUFFER, colours, vertex_colours, GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, index_count, GL_UNSIGNED_INT, nullptr);
  }
};

constexpr std::size_t flight_bytes = std::size_t{32} << 20;

// A range of the surface on its way to the screen.
struct Chunk {
  BandRange range;
  BandMesh bands;  // without what has gone to the driver for good
  std::vector<std::uint32_t> triangles;
  std::vector<Rgba8> colours;
  std::size_t vertices = 0;
  std::optional<Buffers> kept;
};

}  // namespace

struct SurfaceRenderer::State {
  OffscreenContext context;  // first: everything else in here is deleted while it lives
  RenderOptions options;
  BandBuilder builder;
  gl::Program surface = gl::surface_program(), background = gl::background_program();
  gl::VertexArray nothing;
  Buffers passing;
  std::optional<gl::Target> target;
  int target_samples = 0;
  std::vector<Chunk> chunks;
  std::size_t cached = 0, in_flight = 0;

  State(const Surface& s, const RenderOptions& o)
      : options(o), builder(s, corner_normals(s.mesh(), s.adjacency(), o.crease_angle)) {
    for (const BandRange& range : band_ranges(s, o.chunk_slots)) chunks.push_back({range, {}, {}, {}, 0, {}});
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { context.make_current(); }

  GLint location(const char* name) const { return glGetUniformLocation(surface, name); }
  void draw_background() const;
  void set_uniforms(const Camera& camera) const;
  void prepare(Chunk& chunk, std::span<const Rgba8> slot_colours) const;
  void draw_chunk(Chunk& chunk);
};

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

void SurfaceRenderer::State::set_uniforms(const Camera& camera) const {
  const SceneLight light = place_light(options.light, camera);
  const glm::mat4 clip = camera.clip_from_model(builder.origin());
  const glm::vec3 eye(camera.eye - builder.origin());
  glUseProgram(surface);
  glUniformMatrix4fv(location("clip"), 1, GL_FALSE, glm::value_ptr(clip));
  glUniform3fv(location("eye"), 1, glm::value_ptr(eye));
  glUniform3fv(location("towards"), 2, glm::value_ptr(light.towards[0]));
  glUniform1fv(location("strength"), 2, light.strength.data());
  glUniform4f(location("terms"), light.ambient, light.diffuse, light.specular, light.shininess);
}

// The part of the work that needs no OpenGL, for any thread.
void SurfaceRenderer::State::prepare(Chunk& chunk, std::span<const Rgba8> slot_colours) const {
  if (!chunk.kept) {
    chunk.bands = builder.build(chunk.range);
    chunk.vertices = chunk.bands.positions.size();
    chunk.triangles = triangles_of(chunk.bands.indices);
    chunk.bands.indices = {};
  }
  chunk.colours.resize(chunk.vertices);
  colour_bands(chunk.bands, slot_colours, chunk.colours);
}

void SurfaceRenderer::State::draw_chunk(Chunk& chunk) {
  in_flight += sizeof(Rgba8) * chunk.vertices;
  if (!chunk.kept) in_flight += chunk.bands.bytes() + sizeof(std::uint32_t) * chunk.triangles.size();
  if (chunk.kept) {
    chunk.kept->draw(chunk.colours);
  } else if (const std::size_t bytes = chunk.bands.bytes() + 4 * (chunk.vertices + chunk.triangles.size());
             cached + bytes <= options.cache_bytes) {
    cached += bytes;
    chunk.kept.emplace().upload(chunk.bands, chunk.triangles, GL_STATIC_DRAW);
    chunk.kept->draw(chunk.colours);
    chunk.bands.positions = {};
    chunk.bands.normals = {};
  } else {
    passing.upload(chunk.bands, chunk.triangles, GL_STREAM_DRAW);
    passing.draw(chunk.colours);
    chunk.bands = {};
  }
  chunk.colours = {};
  chunk.triangles = {};
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
  s.context.make_current();
  const int factor = std::clamp(s.options.supersampling, 1, 4);
  if (!s.target || s.target->width() != camera.width || s.target->height() != camera.height) {
    s.target.reset();
    s.target.emplace(camera.width, camera.height, factor, s.options.samples);
  }
  s.target->bind();
  glEnable(GL_MULTISAMPLE);
  glDisable(GL_DEPTH_TEST);
  s.draw_background();
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glPrimitiveRestartIndex(BandIndices::restart);
  s.set_uniforms(camera);

  // A few chunks a thread are made at a time; so many, not all of them, are in memory.
  const auto wave = static_cast<std::size_t>(2 * tbb::this_task_arena::max_concurrency());
  for (std::size_t first = 0; first < s.chunks.size(); first += wave) {
    const std::size_t last = std::min(first + wave, s.chunks.size());
    tbb::parallel_for(first, last, [&](std::size_t k) { s.prepare(s.chunks[k], slot_colours); });
    for (std::size_t k = first; k < last; ++k) s.draw_chunk(s.chunks[k]);
    // Or the driver keeps all that passes through until the picture is asked for. Not each time: Mesa's
    // software renderer then reads and writes the whole image once more.
    if (s.in_flight > flight_bytes) {
      glFinish();
      s.in_flight = 0;
    }
  }
  return s.target->resolve();
}

Image render(const Surface& surface, std::span<const Rgba8> slot_colours, const Camera& camera,
             const RenderOptions& options) {
  return SurfaceRenderer(surface, options).draw(slot_colours, camera);
}

}  // namespace verdigris
