#pragma once
// Models and views that several figures share.

#include <span>
#include <vector>

#include "figure_page.hpp"
#include "verdigris/automaton/behaviour.hpp"
#include "verdigris/gl/renderer.hpp"
#include "verdigris/surface/surface.hpp"

/// A model with cells, its renderer and one camera.
struct FigureModel {
  verdigris::Surface surface;
  verdigris::Camera camera;
  verdigris::SurfaceRenderer renderer;

  FigureModel(verdigris::Mesh mesh, double cells, const char* view, int width, int height);

  /// Its triangles, edges one cell wide, with the normals of its vertices over it.
  Panel triangles(const std::string& caption);
  /// Every cell in one of two shades.
  verdigris::Image cells();
  /// Regions as they were after a step; what was not reached then is grey.
  verdigris::Image regions(const verdigris::Field<std::int32_t>& labels,
                           const verdigris::Field<std::int32_t>& arrivals, std::int32_t step);

 private:
  std::vector<verdigris::Rgba8> label_colours_;
};

/// Seconds of processor time that this process has used, on all its threads.
double processor_seconds();

/// [step] share in percent of all cells reached by then, from counts a step.
std::vector<glm::dvec2> percent_reached(std::span<const std::uint64_t> changed, std::size_t cells);
/// First step at which a share of the cells was reached; the last if never.
std::size_t step_of_share(std::span<const std::uint64_t> changed, std::size_t cells, double share);

/// The model in copper, as figure 22 shows it, at a share of its time.
verdigris::Image patina_of(FigureModel& model, double share);
