#pragma once
// Pictures out.

#include <filesystem>

#include "verdigris/picture/image.hpp"

namespace verdigris {

/// Writes an 8-bit PNG: RGB, or RGBA if any pixel is not opaque; tagged sRGB, without a time stamp: the same
/// image gives the same bytes. The file is written aside and renamed, so that it is either whole or not
/// there. Throws InputError for an image without pixels and when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& file);

/// A 16-bit grey PNG, marked linear: levels are data. Otherwise as write_png.
void write_grey_png(const GreyImage& image, const std::filesystem::path& file);

}  // namespace verdigris
