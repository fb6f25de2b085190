#pragma once
// The behaviours that come with the library.

#include "verdigris/automaton/catalogue.hpp"

namespace verdigris {

/// A catalogue of all behaviours of the library, to use or to add to.
Catalogue builtin_catalogue();

}  // namespace verdigris
