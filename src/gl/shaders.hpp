#pragma once
// The programs of the renderer: the surface under its lights, and the background.

#include "objects.hpp"

namespace verdigris::gl {

/// Attributes 0 position, 1 octahedral normal, 2 sRGB colour; uniforms clip, eye, towards[2], strength[2],
/// terms (Ka, Kd, Ks, n). Writes linear light.
Program surface_program();

/// Compiles and links; throws std::runtime_error with the driver's own words.
Program link_program(const char* vertex, const char* fragment);

/// A triangle over the whole image; uniforms top and bottom (linear light, alpha). Draw 3 vertices without
/// attributes.
Program background_program();

}  // namespace verdigris::gl
