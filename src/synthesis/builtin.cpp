#include "verdigris/synthesis/builtin.hpp"

#include "entries.hpp"

namespace verdigris {

PrimitiveCatalogue builtin_primitives() {
  PrimitiveCatalogue catalogue;
  add_noise(catalogue);
  return catalogue;
}

}  // namespace verdigris
