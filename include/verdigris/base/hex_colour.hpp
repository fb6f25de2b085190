#pragma once
// Colours as users write them.

#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

namespace verdigris {

/// sRGB, 0..1, of "#rrggbb"; none for any other text.
std::optional<glm::vec3> hex_colour(std::string_view text);

}  // namespace verdigris
