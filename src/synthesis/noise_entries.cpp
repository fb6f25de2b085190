#include "entries.hpp"

namespace verdigris {

void add_noise(PrimitiveCatalogue&) {}

}  // namespace verdigris
