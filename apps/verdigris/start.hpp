#pragma once
// What a simulation starts from: seeds and barriers of a scene, brought to the cells of its surface.

#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/io/scene.hpp"

/// Where seeds land, and how far the farthest given point was from the surface.
struct PlacedSeeds {
  std::vector<verdigris::Seed> seeds;
  double farthest = 0.0;  ///< model units
};

/// Throws InputError for seeds that are not on the model, too many, or with other weights than there are
/// seeds.
PlacedSeeds place_seeds(const verdigris::Surface& surface, const verdigris::Scene& scene,
                        std::size_t file_vertices, const verdigris::Field<std::uint8_t>& barrier);

/// [slot] 1 where `mask` is at least `threshold`.
verdigris::Field<std::uint8_t> barred_by(const verdigris::Surface& surface,
                                         const verdigris::Field<float>& mask, double threshold);

/// [slot] 1 where the scene's mask bars growth; empty without a mask. Throws InputError.
verdigris::Field<std::uint8_t> make_barrier(const verdigris::Surface& surface, const verdigris::Scene& scene,
                                            const verdigris::ReadReport& read);
