#pragma once
// What comes of a run of corrosion with a material: numbers in real units, curves, cells, pictures.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "verdigris/automaton/catalogue.hpp"
#include "verdigris/behaviours/corrosion_growth.hpp"
#include "verdigris/behaviours/corrosion_statistics.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/material/material.hpp"

/// The material of a scene that has one, checked before the model is read: found, drawable, of a behaviour
/// that corrodes. The scene's parameters get the lifetime of the metal; steps and length of a step are
/// completed. Throws InputError.
verdigris::Material prepare_corrosion(verdigris::Scene& scene);

/// The unit of the model in millimetres, where the plan does not say: models of millimetres are rarely
/// smaller than ten of them, models of metres rarely larger.
double guessed_unit_mm(const verdigris::Mesh& mesh);

/// [step] the numbers of all steps from 0, spots at some thirty of them.
std::vector<verdigris::CorrosionNumbers> corrosion_history(const verdigris::CorrosionGrowth& growth,
                                                           const verdigris::Material& material,
                                                           const verdigris::CorrosionPlan& plan);

/// statistics.csv, spots.csv, plots of their curves, and cells.vtp if wanted, its fields named with their
/// units. Returns the names of the files.
std::vector<std::string> write_corrosion(const std::filesystem::path& out,
                                         const verdigris::CorrosionGrowth& growth,
                                         const verdigris::Material& material,
                                         const verdigris::CorrosionPlan& plan,
                                         std::span<const verdigris::Mask> masks, bool cells);

/// patina-*.png at the ages asked for, as far as they were reached, and picture.png at the last. Returns the
/// names of the files.
std::vector<std::string> draw_corrosion(const std::filesystem::path& out,
                                        const verdigris::CorrosionGrowth& growth,
                                        const verdigris::Material& material, const verdigris::Scene& scene);
