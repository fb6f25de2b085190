#pragma once
// The masks of a scene, brought to the cells of its surface.

#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/io/scene.hpp"

/// Refuses what can be known before the model is read: masks the behaviour does not take, primitives and
/// parameters there are not. Throws InputError.
void check_masks(const verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour);

/// All of them, "barrier" too, [slot] 0 to 1. Throws InputError for files that do not fit the model.
std::vector<verdigris::Mask> make_masks(const verdigris::Surface& surface, const verdigris::Scene& scene,
                                        const verdigris::ReadReport& read);

/// Takes the mask named "barrier" out of `masks`: [slot] 1 where it reaches the scene's threshold. Without
/// one, the barrier of the scene's own mask file; empty where there is none.
verdigris::Field<std::uint8_t> take_barrier(std::vector<verdigris::Mask>& masks,
                                            const verdigris::Surface& surface, const verdigris::Scene& scene,
                                            const verdigris::ReadReport& read);
