#pragma once
// Spreading what samples hold over the surface, as heat flows.

#include <vector>

#include "sample_mesh.hpp"

namespace verdigris {

/// Amounts `held` [sample] become densities [sample], amount / area, after heat has flowed for radius^2 / 2:
/// smoothed as by a Gaussian of standard deviation `radius`. The sum of density times area is the sum of what
/// was held.
std::vector<double> spread_by_heat(const SampleMesh& mesh, std::vector<double> held, double radius);

}  // namespace verdigris
