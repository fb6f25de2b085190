#pragma once
// The first half of a run: from the model a scene names to the surface that cells live on.

#include "options.hpp"
#include "progress.hpp"
#include "verdigris/io/read_mesh.hpp"
#include "verdigris/io/scene.hpp"
#include "verdigris/mesh/mend.hpp"
#include "verdigris/surface/surface.hpp"

/// A model as read and mended, before cells are laid on it.
struct LoadedModel {
  verdigris::Mesh mesh;
  verdigris::ReadReport read;
  verdigris::MendReport mended;
};

/// Reads the scene's model and notes its hash in the scene; makes an empty one for a flat torus. Throws
/// InputError.
LoadedModel load_model(verdigris::Scene& scene);

/// Lays the cells; notes in the scene the size that was used. Throws InputError, also when no triangle holds
/// the centre of a cell.
verdigris::Surface lay_cells(verdigris::Mesh mesh, verdigris::Scene& scene);

/// Area of the cells over that of the mesh; says so when it is off by 2 % or more and not `quiet`.
double check_coverage(const verdigris::Surface& surface, bool quiet);

/// What to call the model in a report.
std::string model_name(const verdigris::Scene& scene);
