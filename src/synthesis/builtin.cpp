#include "verdigris/synthesis/builtin.hpp"

#include "entries.hpp"

namespace verdigris {

PrimitiveCatalogue builtin_primitives() {
  PrimitiveCatalogue catalogue;
  add_noise(catalogue);
  add_midpoint(catalogue);
  add_function_systems(catalogue);
  add_escape_time(catalogue);
  add_lsystems(catalogue);
  return catalogue;
}

}  // namespace verdigris
