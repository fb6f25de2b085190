#include "target.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "verdigris/base/error.hpp"
#include "verdigris/picture/colour.hpp"

namespace verdigris::gl {

namespace {

void check_complete() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the OpenGL driver cannot draw into a half-float image");
}

// 16 bits of linear light are enough for every 8-bit value of sRGB: its steepest slope is 12.92.
std::vector<std::uint8_t> encoding_table() {
  std::vector<std::uint8_t> table(65536);
  for (std::size_t k = 0; k < table.size(); ++k)
    table[k] = static_cast<std::uint8_t>(linear_to_srgb(static_cast<float>(k) / 65535.0f) * 255.0f + 0.5f);
  return table;
}

}  // namespace

Target::Target(int width, int height, int factor, int samples)
    : width_(width), height_(height), factor_(factor) {
  const GLsizei w = width * factor, h = height * factor;
  GLint largest = 0, most_samples = 1;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
  glGetIntegerv(GL_MAX_SAMPLES, &most_samples);
  if (w > largest || h > largest)
    throw InputError("picture size",
                     std::to_string(w) + " x " + std::to_string(h) +
                         " drawn pixels are more than the driver's limit of " + std::to_string(largest) +
                         " on a side",
                     "ask for a smaller picture, or for no supersampling");
  const GLsizei count = std::clamp(samples, 1, most_samples);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  glBindRenderbuffer(GL_RENDERBUFFER, colour_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_RGBA16F, w, h);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  glBindRenderbuffer(GL_RENDERBUFFER, depth_);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT24, w, h);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  check_complete();
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  glBindRenderbuffer(GL_RENDERBUFFER, resolved_colour_);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA16F, w, h);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolved_colour_);
  check_complete();
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  glViewport(0, 0, width_ * factor_, height_ * factor_);
}

Image Target::resolve() const {
  const GLsizei w = width_ * factor_, h = height_ * factor_;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  const auto row_floats = static_cast<std::size_t>(w) * 4;
  std::vector<float> linear(row_floats * static_cast<std::size_t>(h));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, w, h, GL_RGBA, GL_FLOAT, linear.data());

  static const std::vector<std::uint8_t> table = encoding_table();
  Image image{
      width_, height_,
      std::vector<std::uint8_t>(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4)};
  const float share = 1.0f / static_cast<float>(factor_ * factor_);
  tbb::parallel_for(tbb::blocked_range<int>(0, height_, 16), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < width_; ++x) {
        float sum[4] = {};
        for (int dy = 0; dy < factor_; ++dy)
          for (int dx = 0; dx < factor_; ++dx) {
            const float* p = linear.data() +
                             static_cast<std::size_t>((height_ - 1 - y) * factor_ + dy) * row_floats +
                             static_cast<std::size_t>(x * factor_ + dx) * 4;
            for (int c = 0; c < 4; ++c) sum[c] += p[c] * share;
          }
        std::uint8_t* out =
            image.rgba.data() +
            (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
                4;
        const float alpha = std::clamp(sum[3], 0.0f, 1.0f);
        for (int c = 0; c < 3; ++c) {
          const float value = alpha > 0.0f ? std::clamp(sum[c] / alpha, 0.0f, 1.0f) : 0.0f;
          out[c] = table[static_cast<std::size_t>(value * 65535.0f + 0.5f)];
        }
        out[3] = static_cast<std::uint8_t>(alpha * 255.0f + 0.5f);
      }
  });
  return image;
}

}  // namespace verdigris::gl
