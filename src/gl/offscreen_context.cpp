#include "verdigris/gl/offscreen_context.hpp"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstring>

#include "verdigris/base/error.hpp"

namespace verdigris {

struct OffscreenContext::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;

  Egl() = default;
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;
  ~Egl() {
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context)
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    // The display stays initialised: EGL hands the same one to everybody in the process.
    eglDestroyContext(display, context);
  }
};

namespace {

bool has(const char* extensions, const char* name) {
  return extensions && std::strstr(extensions, name);
}

EGLContext make_context(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_CONTEXT;
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                     EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0) {
    if (!has(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) return EGL_NO_CONTEXT;
    config = nullptr;
  }
  const std::array<EGLint, 7> version{EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  if (context == EGL_NO_CONTEXT) return context;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return context;
  eglDestroyContext(display, context);
  return EGL_NO_CONTEXT;
}

}  // namespace

OffscreenContext::OffscreenContext() : egl_(std::make_unique<Egl>()) {
  const auto attempt = [&](EGLDisplay display) {
    egl_->display = display;
    egl_->context = make_context(display);
    return egl_->context != EGL_NO_CONTEXT;
  };
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::string tried = "client extensions only";
  if (has(client, "EGL_EXT_platform_base")) {
    if (has(client, "EGL_EXT_device_enumeration") || has(client, "EGL_EXT_device_base")) {
      std::array<EGLDeviceEXT, 16> devices{};
      EGLint count = 0;
      eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
      tried = std::to_string(count) + " EGL devices";
      for (EGLint k = 0; k < count; ++k)
        if (attempt(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<std::size_t>(k)],
                                             nullptr)))
          return;
    }
    if (has(client, "EGL_MESA_platform_surfaceless")) {
      tried += ", the surfaceless platform";
      if (attempt(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr))) return;
    }
  }
  egl_->display = EGL_NO_DISPLAY;
  egl_->context = EGL_NO_CONTEXT;
  throw InputError(
      "OpenGL", "no context for drawing off screen (tried " + tried + ")",
      "install a driver with EGL and OpenGL 3.3; without a graphics card Mesa's software renderer will do "
      "(Debian: libegl-mesa0 and libgl1-mesa-dri)");
}

OffscreenContext::~OffscreenContext() = default;
OffscreenContext::OffscreenContext(OffscreenContext&&) noexcept = default;
OffscreenContext& OffscreenContext::operator=(OffscreenContext&&) noexcept = default;

void OffscreenContext::make_current() const {
  eglMakeCurrent(egl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl_->context);
}

std::string OffscreenContext::renderer() const {
  make_current();
  return reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

}  // namespace verdigris
