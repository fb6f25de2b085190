#pragma once
// A font of lines and arcs, in the manner of technical lettering: it needs no file and turns to any angle.

#include <cstdint>
#include <glm/vec2.hpp>
#include <string_view>
#include <vector>

namespace verdigris {

inline constexpr double cap_height = 700.0;  ///< font units

/// The pen's ways, in font units, y up, base line at 0.
struct Glyph {
  double advance;
  std::vector<std::vector<glm::dvec2>> lines;
};

/// Latin letters, digits and what labels of plots need; a box for anything else.
const Glyph& glyph_of(std::uint32_t character);

/// Takes the first character off a UTF-8 text that is not empty. What is not UTF-8 counts byte by byte.
std::uint32_t next_character(std::string_view& utf8);

}  // namespace verdigris
