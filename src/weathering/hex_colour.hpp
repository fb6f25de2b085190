#pragma once
// Colours as users write them.

#include <fmt/format.h>

#include <glm/vec3.hpp>
#include <string>

#include "verdigris/base/error.hpp"
#include "verdigris/base/hex_colour.hpp"

namespace verdigris::weathering {

/// sRGB, 0..1, of "#rrggbb". Throws InputError, naming `owner`, for any other text.
inline glm::vec3 colour_of(const std::string& text, const char* owner) {
  const auto colour = hex_colour(text);
  if (!colour) throw InputError(owner, fmt::format("'{}' is no colour", text), "write \"#rrggbb\"");
  return *colour;
}

}  // namespace verdigris::weathering
