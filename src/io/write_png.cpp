#include "verdigris/io/write_png.hpp"

#include <png.h>

#include <string>
#include <vector>

#include "verdigris/io/replace_file.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

namespace {

// libpng reports by calling back; an exception thrown from there passes through its C frames only with luck,
// so the message is kept and libpng's own jump taken.
void keep_message(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}
void no_warning(png_structp, png_const_charp) {}

// No object with a destructor lives in this frame: the jump would pass over it.
bool encode(png_structp png, png_infop info, std::FILE* stream, const Image& image, bool opaque,
            png_bytep* rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_init_io(png, stream);
  png_set_compression_level(png, 6);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

bool is_opaque(const Image& image) {
  for (std::size_t k = 3; k < image.rgba.size(); k += 4)
    if (image.rgba[k] != 255) return false;
  return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  if (image.width <= 0 || image.height <= 0 || image.rgba.size() != 4 * width * height)
    throw InputError(file.string(), "the image has no pixels, or not as many as its size says",
                     "give it a width and height of at least 1");
  const bool opaque = is_opaque(image);
  const std::size_t channels = opaque ? 3 : 4;
  std::vector<png_byte> pixels(channels * width * height);
  for (std::size_t k = 0; k < width * height; ++k)
    for (std::size_t c = 0; c < channels; ++c) pixels[channels * k + c] = image.rgba[4 * k + c];
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = pixels.data() + y * channels * width;

  ReplaceFile out(file);
  std::string message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, no_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool done = info && encode(png, info, out.stream(), image, opaque, rows.data());
  png_destroy_write_struct(&png, &info);
  if (!done)
    throw InputError(file.string(), "writing failed: " + message, "check the free space and the permissions");
  out.commit();
}

}  // namespace verdigris
