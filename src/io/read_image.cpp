#include "verdigris/io/read_image.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 32768
#include <fmt/format.h>

#include <stb/stb_image.h>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "file_bytes.hpp"
#include "verdigris/base/error.hpp"

namespace verdigris {

GreyImage read_grey_image(const std::filesystem::path& file) {
  io::FileBytes bytes = io::read_file(file);
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw InputError(io::shown(file), "it is too large for an image", "give one below 2 GB");
  int width = 0, height = 0, channels = 0;
  constexpr std::int64_t most_pixels = 1 << 28;
  if (stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &channels) != 0 &&
      std::int64_t{width} * height > most_pixels)
    throw InputError(io::shown(file),
                     fmt::format("it has {} x {} pixels, more than a mask can use", width, height),
                     "make it smaller: 16384 x 16384 at most");
  struct Free {
    void operator()(stbi_us* pixels) const { stbi_image_free(pixels); }
  };
  const std::unique_ptr<stbi_us, Free> pixels(
      stbi_load_16_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                               &width, &height, &channels, 0));
  if (!pixels)
    throw InputError(io::shown(file),
                     fmt::format("it is no PNG or JPEG image, or damaged ({})", stbi_failure_reason()),
                     "give another file, or save it anew as PNG");
  GreyImage image{width, height, {}};
  image.levels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t k = 0; k < image.levels.size(); ++k) {
    const stbi_us* p = pixels.get() + k * static_cast<std::size_t>(channels);
    image.levels[k] =
        channels < 3 ? p[0]
                     : static_cast<std::uint16_t>(std::lround(0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]));
  }
  return image;
}

}  // namespace verdigris
