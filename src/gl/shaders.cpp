#include "shaders.hpp"

#include <stdexcept>
#include <string>

namespace verdigris::gl {

namespace {

// Colours are decoded before they are interpolated: a mean of two colours is a mean of light. Multiplied by
// alpha, because a cell that is not there has no say in the colour of its neighbours. Centroid, because
// triangles may be much smaller than a pixel, and values extrapolated to its centre would be wild.
constexpr const char* surface_vertex = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 packed_normal;
layout(location = 2) in vec4 encoded;
uniform mat4 clip;
centroid out vec3 at;
centroid out vec3 normal;
centroid out vec4 material;

vec3 unpack(vec2 p) {
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x < 0.0 ? fold : -fold;
  n.y += n.y < 0.0 ? fold : -fold;
  return normalize(n);
}

vec3 decode(vec3 c) {
  return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

void main() {
  at = position;
  normal = unpack(packed_normal);
  material = vec4(decode(encoded.rgb) * encoded.a, encoded.a);
  gl_Position = clip * vec4(position, 1.0);
}
)";

// C = (Ka + Kd (L.N) + Ks (R.E)^n) Cm, see picture/light.hpp. Clamped here, so that the mean of the samples
// is that of what a screen can show and highlights get no jagged edge.
constexpr const char* surface_fragment = R"(#version 330 core
centroid in vec3 at;
centroid in vec3 normal;
centroid in vec4 material;
uniform vec3 eye;
uniform vec3 towards[2];
uniform float strength[2];
uniform vec4 terms;
out vec4 colour;

void main() {
  if (material.a < 0.5) discard;  // a hole: half way to a cell that is not there
  vec3 n = normalize(normal);
  if (!gl_FrontFacing) n = -n;
  vec3 to_eye = normalize(eye - at);
  float sum = terms.x;
  for (int k = 0; k < 2; ++k) {
    float incidence = dot(towards[k], n);
    float gloss = max(dot(2.0 * incidence * n - towards[k], to_eye), 0.0);
    sum += strength[k] * (terms.y * max(incidence, 0.0) + terms.z * pow(gloss, terms.w));
  }
  colour = vec4(min(sum * material.rgb / material.a, 1.0), 1.0);
}
)";

constexpr const char* background_vertex = R"(#version 330 core
out float height;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  height = 0.5 * corner.y + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr const char* background_fragment = R"(#version 330 core
in float height;
uniform vec4 top;
uniform vec4 bottom;
out vec4 colour;
void main() {
  vec4 c = mix(bottom, top, height);
  colour = vec4(c.rgb * c.a, c.a);
}
)";

void attach(GLuint program, GLenum stage, const char* source) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    std::string log(1024, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    throw std::runtime_error("the OpenGL driver rejects a shader: " + log);
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // goes with the program
}

}  // namespace

Program link_program(const char* vertex, const char* fragment) {
  Program program;
  attach(program, GL_VERTEX_SHADER, vertex);
  attach(program, GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(program);
  GLint good = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (!good) throw std::runtime_error("the OpenGL driver cannot link a program");
  return program;
}

Program surface_program() {
  return link_program(surface_vertex, surface_fragment);
}
Program background_program() {
  return link_program(background_vertex, background_fragment);
}

}  // namespace verdigris::gl
