#pragma once
// OpenGL names that delete themselves. Valid only while their context is.

#include <epoxy/gl.h>

#include <utility>

namespace verdigris::gl {

/// Owns one OpenGL name; `Kind` says how it is made and deleted.
template <class Kind>
class Object {
 public:
  Object() : name_(Kind::make()) {}
  ~Object() {
    if (name_) Kind::destroy(name_);
  }
  Object(Object&& other) noexcept : name_(std::exchange(other.name_, 0u)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  operator GLuint() const { return name_; }

 private:
  GLuint name_;
};

struct BufferKind {
  static GLuint make() {
    GLuint n = 0;
    glGenBuffers(1, &n);
    return n;
  }
  static void destroy(GLuint n) { glDeleteBuffers(1, &n); }
};
struct VertexArrayKind {
  static GLuint make() {
    GLuint n = 0;
    glGenVertexArrays(1, &n);
    return n;
  }
  static void destroy(GLuint n) { glDeleteVertexArrays(1, &n); }
};
struct FramebufferKind {
  static GLuint make() {
    GLuint n = 0;
    glGenFramebuffers(1, &n);
    return n;
  }
  static void destroy(GLuint n) { glDeleteFramebuffers(1, &n); }
};
struct RenderbufferKind {
  static GLuint make() {
    GLuint n = 0;
    glGenRenderbuffers(1, &n);
    return n;
  }
  static void destroy(GLuint n) { glDeleteRenderbuffers(1, &n); }
};
struct ProgramKind {
  static GLuint make() { return glCreateProgram(); }
  static void destroy(GLuint n) { glDeleteProgram(n); }
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Framebuffer = Object<FramebufferKind>;
using Renderbuffer = Object<RenderbufferKind>;
using Program = Object<ProgramKind>;

}  // namespace verdigris::gl
