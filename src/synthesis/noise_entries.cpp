#include "entries.hpp"
#include "verdigris/synthesis/cellular_noise.hpp"
#include "verdigris/synthesis/domain_warp.hpp"
#include "verdigris/synthesis/fractal_noise.hpp"
#include "verdigris/synthesis/lattice_noise.hpp"
#include "verdigris/synthesis/multifractals.hpp"

namespace verdigris {

void add_noise(PrimitiveCatalogue& catalogue) {
  catalogue.add(primitive_entry<GradientNoise>());
  catalogue.add(primitive_entry<ValueNoise>());
  catalogue.add(primitive_entry<CellularNoise>());
  catalogue.add(primitive_entry<MultiresolutionSum>());
  catalogue.add(primitive_entry<Fbm>());
  catalogue.add(primitive_entry<Turbulence>());
  catalogue.add(primitive_entry<RidgedMultifractal>());
  catalogue.add(primitive_entry<Multifractal>());
  catalogue.add(primitive_entry<HybridMultifractal>());
  catalogue.add(primitive_entry<DomainWarp>());
}

}  // namespace verdigris
