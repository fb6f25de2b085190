#pragma once
// The program that draws layers over metal.

#include "objects.hpp"
#include "verdigris/picture/layers.hpp"

namespace verdigris::gl {

/// Attributes 0 position, 1 octahedral normal, 2 optical depths (of LayerCell::most_depth), 3 presence, tint
/// and openness; uniforms clip, eye, towards[2], strength[2], and those of set_layers. Writes linear light.
/// `fine`: lit at every pixel; else at vertices, and interpolated.
Program layer_program(bool fine);

/// Looks, studio and whether absent metal is a hole. The program must be in use.
void set_layers(GLuint program, const LayerStack& stack, const SceneStudio& studio, bool holes);

}  // namespace verdigris::gl
