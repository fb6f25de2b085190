#pragma once
// The kinds of film there are: make_film_subject chooses.

#include <memory>

#include "film_subject.hpp"
#include "verdigris/automaton/catalogue.hpp"

/// A timeline: made anew each time it is looked at.
std::unique_ptr<FilmSubject> weathering_film(verdigris::Scene& scene, Progress& progress, bool quiet);

/// Corrosion of a material: grown once, for any age can be drawn then. Null when the user stopped it.
std::unique_ptr<FilmSubject> corrosion_film(verdigris::Scene& scene,
                                            const verdigris::BehaviourEntry& behaviour, Progress& progress,
                                            bool quiet);

/// Any other behaviour, step by step; `behaviour` must outlive it. Null when the user stopped it.
std::unique_ptr<FilmSubject> steps_film(verdigris::Scene& scene, const verdigris::BehaviourEntry& behaviour,
                                        Progress& progress, bool quiet);

/// Steps to the last one, 0: until nothing changes. Whether it came there; the time it took is added.
bool grow_to(verdigris::AnySimulation& simulation, std::uint64_t last, Progress& progress, double& seconds);
