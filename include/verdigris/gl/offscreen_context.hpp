#pragma once
// An OpenGL context without a window or a display.

#include <memory>
#include <string>

namespace verdigris {

/// OpenGL 3.3 core through EGL: on the first device that gives a context, else without a surface (Mesa).
/// Lives as long as the object and is current on the thread that made it. Throws InputError, with what was
/// tried and what to install, where there is none.
class OffscreenContext {
 public:
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(OffscreenContext&&) noexcept;
  OffscreenContext& operator=(OffscreenContext&&) noexcept;

  /// Makes this context the current one of the calling thread.
  void make_current() const;
  /// The driver's own name for itself, for reports.
  std::string renderer() const;

 private:
  struct Egl;
  std::unique_ptr<Egl> egl_;
};

}  // namespace verdigris
