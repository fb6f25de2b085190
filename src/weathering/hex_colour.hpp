#pragma once
// Colours as users write them.

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <string>

#include "verdigris/base/error.hpp"

namespace verdigris::weathering {

/// sRGB, 0..1, of "#rrggbb". Throws InputError, naming `owner`, for any other text.
inline glm::vec3 colour_of(const std::string& text, const char* owner) {
  const bool hex = text.size() == 7 && text[0] == '#' &&
                   text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
  if (!hex) throw InputError(owner, fmt::format("'{}' is no colour", text), "write \"#rrggbb\"");
  const unsigned long value = std::stoul(text.substr(1), nullptr, 16);
  return {static_cast<float>(value >> 16) / 255.0f, static_cast<float>(value >> 8 & 255u) / 255.0f,
          static_cast<float>(value & 255u) / 255.0f};
}

}  // namespace verdigris::weathering
