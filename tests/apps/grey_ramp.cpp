#include "grey_ramp.hpp"

#include "verdigris/io/write_png.hpp"

void write_grey_ramp(const std::filesystem::path& file, int width, int height, int step) {
  verdigris::GreyImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.levels.push_back(static_cast<std::uint16_t>(x * step));
  verdigris::write_grey_png(image, file);
}
