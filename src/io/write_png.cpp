#include "verdigris/io/write_png.hpp"

#include <png.h>

#include <string>
#include <vector>

#include "verdigris/base/error.hpp"
#include "verdigris/io/replace_file.hpp"

namespace verdigris {

namespace {

// libpng reports by calling back; an exception thrown from there passes through its C frames only with luck,
// so the message is kept and libpng's own jump taken.
void keep_message(png_structp png, png_const_charp message) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = message;
  png_longjmp(png, 1);
}
void no_warning(png_structp, png_const_charp) {}

// What libpng is to be told of an image.
struct Layout {
  int width, height, bits, colour;
};

// No object with a destructor lives in this frame: the jump would pass over it.
bool encode(png_structp png, png_infop info, std::FILE* stream, const Layout& layout, png_bytep* rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_init_io(png, stream);
  png_set_compression_level(png, 6);
  png_set_IHDR(png, info, static_cast<png_uint_32>(layout.width), static_cast<png_uint_32>(layout.height),
               layout.bits, layout.colour, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (layout.colour == PNG_COLOR_TYPE_GRAY)
    png_set_gAMA(png, info, 1.0);
  else
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_write_info(png, info);
  png_write_image(png, rows);
  png_write_end(png, nullptr);
  return true;
}

// `pixels`: rows of `row_bytes`, top to bottom.
void write(const std::filesystem::path& file, const Layout& layout, std::vector<png_byte>& pixels,
           std::size_t row_bytes) {
  std::vector<png_bytep> rows(static_cast<std::size_t>(layout.height));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = pixels.data() + y * row_bytes;
  ReplaceFile out(file);
  std::string message;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, no_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool done = info && encode(png, info, out.stream(), layout, rows.data());
  png_destroy_write_struct(&png, &info);
  if (!done)
    throw InputError(file.string(), "writing failed: " + message, "check the free space and the permissions");
  out.commit();
}

void check_size(const std::filesystem::path& file, int width, int height, std::size_t values,
                std::size_t each) {
  if (width <= 0 || height <= 0 ||
      values != each * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    throw InputError(file.string(), "the image has no pixels, or not as many as its size says",
                     "give it a width and height of at least 1");
}

bool is_opaque(const Image& image) {
  for (std::size_t k = 3; k < image.rgba.size(); k += 4)
    if (image.rgba[k] != 255) return false;
  return true;
}

}  // namespace

void write_png(const Image& image, const std::filesystem::path& file) {
  check_size(file, image.width, image.height, image.rgba.size(), 4);
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const bool opaque = is_opaque(image);
  const std::size_t channels = opaque ? 3 : 4;
  std::vector<png_byte> pixels(channels * width * height);
  for (std::size_t k = 0; k < width * height; ++k)
    for (std::size_t c = 0; c < channels; ++c) pixels[channels * k + c] = image.rgba[4 * k + c];
  write(file, {image.width, image.height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA}, pixels,
        channels * width);
}

void write_grey_png(const GreyImage& image, const std::filesystem::path& file) {
  check_size(file, image.width, image.height, image.levels.size(), 1);
  std::vector<png_byte> pixels;
  pixels.reserve(2 * image.levels.size());
  for (const std::uint16_t level : image.levels) {  // PNG stores the upper byte first
    pixels.push_back(static_cast<png_byte>(level >> 8));
    pixels.push_back(static_cast<png_byte>(level & 0xff));
  }
  write(file, {image.width, image.height, 16, PNG_COLOR_TYPE_GRAY}, pixels,
        2 * static_cast<std::size_t>(image.width));
}

}  // namespace verdigris
