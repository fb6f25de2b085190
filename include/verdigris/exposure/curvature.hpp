#pragma once
// How the surface bends, seen over a radius.

#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

/// Mean curvature (k1 + k2) / 2, [slot] in 1 / model unit: positive where convex, 1 / R on a sphere of radius
/// R, 1 / (2 R) on a cylinder, 0 on a saddle that is symmetric.
///
/// Every edge holds curvature, half its length times the angle its faces turn by (the normal cycle of
/// Cohen-Steiner & Morvan 2003); that is spread over the surface by heat flow, as by a Gaussian of standard
/// deviation `radius` (model units, > 0), so that facets smaller than the radius do not show, and a sharp
/// edge is a band as wide as it. Values do not flow over edges that are not linked. Throws InputError for
/// another radius.
Field<float> mean_curvature(const Surface& surface, double radius);

/// A radius that suits most models: a hundredth of the diagonal of the bounds, at least one and a half cells.
double default_radius(const Surface& surface);

/// Convex places, [slot] 0..1: 1 - exp(-4 radius H) where H > 0. An edge that turns by 90 degrees comes to
/// 0.71.
Field<float> convexity(const Surface& surface, double radius);
/// Hollow places, the same of -H.
Field<float> concavity(const Surface& surface, double radius);

}  // namespace verdigris
