// picture/layers.cpp and picture/studio.cpp in GLSL; a test holds both together to 1/255.
#include "layer_program.hpp"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vec4.hpp>
#include <string>

#include "shaders.hpp"

namespace verdigris::gl {

namespace {

// What both stages share. Looks: the layers from above, the substrate, then what stands where metal is gone.
constexpr const char* light_source = R"(
uniform vec3 eye;
uniform vec3 towards[2];
uniform float strength[2];
uniform int layers;
uniform bool holes;
uniform vec3 colour_near[6];
uniform vec3 colour_far[6];
uniform vec4 terms[6];   // Ka, Kd, Ks, n
uniform vec3 mirror[6];  // share, roughness, metallic
uniform vec3 room[3];    // floor, horizon, ceiling
uniform vec3 up;
uniform vec3 box_towards[3];
uniform vec3 box_across[3];
uniform vec3 box_along[3];
uniform vec3 box_light[3];

vec3 studio(vec3 from, float roughness) {
  float height = dot(from, up);
  float soft = 0.15 + 0.85 * roughness;
  vec3 sum = mix(room[0], room[1], smoothstep(-0.5 - soft, soft, height));
  sum = mix(sum, room[2], smoothstep(-0.2, 1.0, height));
  float edge = 0.10 + 1.60 * roughness;
  for (int k = 0; k < 3; ++k) {
    float far = dot(from, box_towards[k]);
    if (far <= 0.0) continue;
    float x = abs(dot(from, box_across[k])) / far;
    float y = abs(dot(from, box_along[k])) / far;
    sum += (1.0 - smoothstep(1.0 - edge, 1.0 + edge, x)) * (1.0 - smoothstep(1.0 - edge, 1.0 + edge, y)) *
           box_light[k];
  }
  return sum;
}

vec3 mirrored;
float facing, tint, open;
vec2 incidence, gloss;

vec3 lit(int k) {
  vec3 own = mix(colour_near[k], colour_far[k], tint);
  float sum = open * terms[k].x, lamps = 0.5 + 0.5 * open;
  for (int l = 0; l < 2; ++l)
    sum += lamps * strength[l] * (terms[k].y * max(incidence[l], 0.0) + terms[k].z * pow(gloss[l], terms[k].w));
  vec3 light = sum * own;
  if (mirror[k].x > 0.0) {
    float grazing = pow(1.0 - max(facing, 0.0), 5.0) * (1.0 - mirror[k].y);
    vec3 tinted = mix(vec3(1.0), own, mirror[k].z * (1.0 - grazing));
    light += open * mirror[k].x * tinted * studio(mirrored, mirror[k].y);
  }
  return light;
}

vec3 lit_cell(vec3 n, vec3 to_eye, vec4 depth, vec3 state) {
  tint = state.y;
  open = state.z;
  facing = dot(n, to_eye);
  mirrored = 2.0 * facing * n - to_eye;
  for (int l = 0; l < 2; ++l) {
    incidence[l] = dot(towards[l], n);
    gloss[l] = max(dot(2.0 * incidence[l] * n - towards[l], to_eye), 0.0);
  }
  vec3 sum = vec3(0.0);
  float passed = 1.0;
  for (int k = 0; k < layers; ++k) {
    if (depth[k] <= 0.0) continue;
    float through = exp(-depth[k]);
    sum += passed * (1.0 - through) * lit(k);
    passed *= through;
  }
  if (passed > 1e-4) sum += passed * lit(layers);
  if (!holes && state.x < 1.0) sum = mix(lit(layers + 1), sum, state.x);
  return min(sum, 1.0);
}
)";

constexpr const char* vertex_inputs = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 packed_normal;
layout(location = 2) in vec4 depths;
layout(location = 3) in vec3 presence_tint_open;
uniform mat4 clip;
centroid out vec3 state;

vec3 unpack(vec2 p) {
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x < 0.0 ? fold : -fold;
  n.y += n.y < 0.0 ? fold : -fold;
  return normalize(n);
}
)";

// Lit where it is seen: for cells larger than pixels.
constexpr const char* fine_vertex = R"(
centroid out vec3 at;
centroid out vec3 normal;
centroid out vec4 depth;
void main() {
  at = position;
  normal = unpack(packed_normal);
  depth = depths * 12.0;
  state = presence_tint_open;
  gl_Position = clip * vec4(position, 1.0);
}
)";
constexpr const char* fine_fragment = R"(
centroid in vec3 at;
centroid in vec3 normal;
centroid in vec4 depth;
centroid in vec3 state;
out vec4 colour;
void main() {
  if (holes && state.x < 0.5) discard;
  vec3 n = normalize(normal);
  colour = vec4(lit_cell(gl_FrontFacing ? n : -n, normalize(eye - at), depth, state), 1.0);
}
)";

// Lit in the middle of each cell: where cells are no larger than pixels a software renderer, which shades
// blocks of 16 pixels for each triangle, takes a quarter of the time (cup, 220,000 cells).
constexpr const char* coarse_vertex = R"(
centroid out vec3 light;
void main() {
  vec3 n = unpack(packed_normal), to_eye = normalize(eye - position);
  state = presence_tint_open;
  light = lit_cell(dot(n, to_eye) < 0.0 ? -n : n, to_eye, depths * 12.0, state);
  gl_Position = clip * vec4(position, 1.0);
}
)";
constexpr const char* coarse_fragment = R"(#version 330 core
centroid in vec3 light;
centroid in vec3 state;
uniform bool holes;
out vec4 colour;
void main() {
  if (holes && state.x < 0.5) discard;
  colour = vec4(light, 1.0);
}
)";

}  // namespace

Program layer_program(bool fine) {
  const std::string version = "#version 330 core\n";
  if (fine)
    return link_program((version + vertex_inputs + fine_vertex).c_str(),
                        (version + light_source + fine_fragment).c_str());
  return link_program((version + light_source + vertex_inputs + coarse_vertex).c_str(), coarse_fragment);
}

void set_layers(GLuint program, const LayerStack& stack, const SceneStudio& studio, bool holes) {
  assert(stack.layers.size() <= most_layers);
  const auto at = [&](const char* name, std::size_t k) {
    return glGetUniformLocation(program, (name + ("[" + std::to_string(k) + "]")).c_str());
  };
  const auto vector = [](GLint location, glm::vec3 v) { glUniform3f(location, v.x, v.y, v.z); };
  const auto look = [&](std::size_t k, const LayerLook& l) {
    vector(at("colour_near", k), l.colour);
    vector(at("colour_far", k), l.far_colour);
    glUniform4f(at("terms", k), l.ambient, l.diffuse, l.specular, l.shininess);
    vector(at("mirror", k), {l.mirror, l.roughness, l.metallic});
  };
  const std::size_t count = std::min(stack.layers.size(), most_layers);
  for (std::size_t k = 0; k < count; ++k) look(k, stack.layers[k]);
  look(count, stack.substrate);
  look(count + 1, stack.gone);
  glUniform1i(glGetUniformLocation(program, "layers"), static_cast<GLint>(count));
  glUniform1i(glGetUniformLocation(program, "holes"), holes);
  vector(at("room", 0), studio.floor);
  vector(at("room", 1), studio.horizon);
  vector(at("room", 2), studio.ceiling);
  vector(glGetUniformLocation(program, "up"), studio.up);
  for (std::size_t k = 0; k < studio.towards.size(); ++k) {
    vector(at("box_towards", k), studio.towards[k]);
    vector(at("box_across", k), studio.across[k]);
    vector(at("box_along", k), studio.along[k]);
    vector(at("box_light", k), studio.light[k]);
  }
}

}  // namespace verdigris::gl
