#include "figure_models.hpp"

#include <algorithm>
#include <ctime>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "verdigris/picture/normals.hpp"
#include "verdigris/picture/palette.hpp"
#include "verdigris/picture/regions.hpp"
#include "verdigris/surface/ghost_values.hpp"
#include "verdigris/surface/walk.hpp"

using namespace verdigris;

namespace {

constexpr Rgba8 light_cell{214, 206, 190, 255}, dark_cell{150, 122, 92, 255}, ink{60, 56, 50, 255};

Surface surface_of(Mesh mesh, double cells) {
  SurfaceOptions options;
  options.cell_size = cell_size_for(mesh, cells);
  return make_surface(std::move(mesh), options);
}

template <typename Visit>
void for_owned(const Surface& surface, const Visit& visit) {
  for (std::uint32_t row = 0; row < surface.rows().size(); ++row)
    for (std::uint32_t slot = surface.owned(row).begin; slot < surface.owned(row).end; ++slot)
      visit(row, slot);
}

}  // namespace

FigureModel::FigureModel(Mesh mesh, double cells, const char* view, int width, int height)
    : surface(surface_of(std::move(mesh), cells)),
      camera(frame_mesh(surface.mesh(), view, {UpAxis::y, 30.0, 0.04, width, height})),
      renderer(surface) {}

Panel FigureModel::triangles(const std::string& caption) {
  std::vector<Rgba8> colours(surface.slot_count(), ink);
  for_owned(surface, [&](std::uint32_t row, std::uint32_t slot) {
    const std::uint32_t patch = surface.patch_of_row(row);
    const glm::dvec2 p = surface.centre(surface.grid_row(patch, row),
                                        static_cast<std::int32_t>(slot - surface.rows()[row].base));
    double inside = 1e300;
    for (int k = 0; k < 3; ++k) inside = std::min(inside, -beyond_edge(surface.frame(patch), k, p));
    const auto share = static_cast<float>(std::clamp(inside / surface.cell_size() - 0.6, 0.0, 1.0));
    colours[slot] = from_linear(glm::mix(to_linear(ink), to_linear(light_cell), share));
  });
  copy_to_ghosts(surface, colours);
  Panel panel{caption, renderer.draw(colours, camera)};
  const Mesh& mesh = surface.mesh();
  const std::vector<glm::vec3> normals = corner_normals(mesh, surface.adjacency(), 180.0);
  const Bounds bounds = mesh_bounds(mesh);
  const double length = 0.06 * glm::distance(bounds.lower, bounds.upper);
  std::vector<bool> done(mesh.positions.size(), false);
  for (std::size_t corner = 0; corner < normals.size(); ++corner) {
    const std::uint32_t vertex = mesh.triangles[corner / 3][static_cast<int>(corner % 3)];
    const glm::dvec3 p = mesh.positions[vertex], n = normals[corner];
    if (done[vertex] || glm::dot(n, camera.eye - p) < 0.15 * glm::distance(camera.eye, p)) continue;
    done[vertex] = true;
    const glm::dvec3 from = camera.to_pixel(p), to = camera.to_pixel(p + length * n);
    panel.overlay.line({from.x, from.y}, {to.x, to.y}, "#c2410c", 1.3);
  }
  return panel;
}

Image FigureModel::cells() {
  std::vector<Rgba8> colours(surface.slot_count(), light_cell);
  for_owned(surface, [&](std::uint32_t row, std::uint32_t slot) {
    const std::uint32_t column = slot - surface.rows()[row].base;
    if (((column + row) & 1u) != 0) colours[slot] = dark_cell;
  });
  copy_to_ghosts(surface, colours);
  return renderer.draw(colours, camera);
}

Image FigureModel::regions(const Field<std::int32_t>& labels, const Field<std::int32_t>& arrivals,
                           std::int32_t step) {
  if (label_colours_.empty()) label_colours_ = label_colours(surface, labels);
  Field<std::int32_t> shown(labels.size());
  for (std::size_t slot = 0; slot < shown.size(); ++slot)
    shown[slot] = arrivals[slot] >= 0 && arrivals[slot] <= step ? labels[slot] : -1;
  return renderer.draw(colour_labels(surface, shown, label_colours_), camera);
}

double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::vector<glm::dvec2> percent_reached(std::span<const std::uint64_t> changed, std::size_t cells) {
  std::vector<glm::dvec2> points;
  double sum = 0.0;
  for (std::size_t step = 0; step < changed.size(); ++step) {
    sum += static_cast<double>(changed[step]);
    points.emplace_back(step, 100.0 * sum / static_cast<double>(cells));
  }
  return points;
}

std::size_t step_of_share(std::span<const std::uint64_t> changed, std::size_t cells, double share) {
  double sum = 0.0;
  for (std::size_t step = 0; step < changed.size(); ++step) {
    sum += static_cast<double>(changed[step]);
    if (sum >= share * static_cast<double>(cells)) return step;
  }
  return changed.empty() ? 0 : changed.size() - 1;
}
