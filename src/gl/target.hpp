#pragma once
// What is drawn into: a multisampled image in linear light, and the way from there to 8 bits.

#include <cstddef>

#include "objects.hpp"
#include "verdigris/picture/image.hpp"

namespace verdigris::gl {

/// An off-screen image of `width` x `height` pixels, each of `factor` x `factor` drawn ones.
class Target {
 public:
  /// Throws InputError when the driver cannot draw that large.
  Target(int width, int height, int factor, int samples);

  /// Binds it and sets the viewport.
  void bind() const;
  /// Means of all samples of a pixel in linear light, then encoded as sRGB with straight alpha.
  Image resolve() const;

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_, height_, factor_;
  Framebuffer drawn_, resolved_;
  Renderbuffer colour_, depth_, resolved_colour_;
};

}  // namespace verdigris::gl
