#include "verdigris/base/hex_colour.hpp"

#include <charconv>

namespace verdigris {

std::optional<glm::vec3> hex_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string_view::npos)
    return std::nullopt;
  unsigned value = 0;
  std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  return glm::vec3(static_cast<float>(value >> 16), static_cast<float>(value >> 8 & 255u),
                   static_cast<float>(value & 255u)) /
         255.0f;
}

}  // namespace verdigris
