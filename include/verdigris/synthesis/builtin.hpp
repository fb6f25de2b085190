#pragma once
// The primitives that come with the library.

#include "verdigris/synthesis/primitive_catalogue.hpp"

namespace verdigris {

/// A catalogue of all primitives of the library, to use or to add to.
PrimitiveCatalogue builtin_primitives();

}  // namespace verdigris
