#include "verdigris/behaviours/builtin.hpp"

#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/behaviours/life_simulation.hpp"
#include "verdigris/behaviours/voronoi_growth.hpp"

namespace verdigris {

Catalogue builtin_catalogue() {
  Catalogue catalogue;
  catalogue.add(voronoi_entry());
  catalogue.add(life_entry());
  catalogue.add(corrosion_entry());
  return catalogue;
}

}  // namespace verdigris
