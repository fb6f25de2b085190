#pragma once
// Pictures in.

#include <filesystem>

#include "verdigris/picture/image.hpp"

namespace verdigris {

/// Grey levels of a PNG (8 or 16 bit) or JPEG file as they are stored, 0 black, 65535 white; of colours their
/// luminance (Rec. 709 weights on the encoded values), transparency does not count. Throws InputError, naming
/// the file, when there is none, it is neither PNG nor JPEG, or damaged.
GreyImage read_grey_image(const std::filesystem::path& file);

}  // namespace verdigris
