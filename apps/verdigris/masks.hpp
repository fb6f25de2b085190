#pragma once
// The masks of a scene, brought to the cells of its surface.

#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/exposure/source_masks.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/io/scene.hpp"

/// Refuses what can be known before the model is read: sources and parameters there are not, bounds and
/// scales of no use, formulas that lead back to themselves; with a behaviour also masks that it neither takes
/// nor reaches by formulas. Throws InputError.
void check_masks(const verdigris::Scene& scene);
void check_masks(const verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour);

/// All masks of a scene by all sources, [slot], as they are: distances stay distances. Directions that a
/// source was not given are the scene's up. The scene has been checked. Throws InputError for files that do
/// not fit the model.
std::vector<verdigris::Mask> all_masks(verdigris::SourceMasks& sources, const verdigris::Scene& scene,
                                       const verdigris::ReadReport& read);

/// Those that the behaviour takes, "barrier" too, [slot] 0 to 1; not those that only serve formulas.
/// Throws as all_masks.
std::vector<verdigris::Mask> make_masks(const verdigris::Surface& surface, const verdigris::Scene& scene,
                                        const verdigris::BehaviourEntry& behaviour,
                                        const verdigris::ReadReport& read);

/// Takes the mask named "barrier" out of `masks`: [slot] 1 where it reaches the scene's threshold. Without
/// one, the barrier of the scene's own mask file; empty where there is none.
verdigris::Field<std::uint8_t> take_barrier(std::vector<verdigris::Mask>& masks,
                                            const verdigris::Surface& surface, const verdigris::Scene& scene,
                                            const verdigris::ReadReport& read);
