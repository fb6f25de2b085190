#include "grey_levels.hpp"

#include <png.h>

std::vector<std::uint16_t> grey_levels(const std::filesystem::path& file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return {};
  image.format = PNG_FORMAT_LINEAR_Y;
  std::vector<std::uint16_t> levels(std::size_t{image.width} * image.height);
  png_image_finish_read(&image, nullptr, levels.data(), 0, nullptr);
  return levels;
}
