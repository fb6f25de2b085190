#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "nearest.hpp"
#include "nearest_on_triangle.hpp"
#include "verdigris/base/error.hpp"
#include "verdigris/surface/surface.hpp"

namespace verdigris {

namespace {

// Embree culls in float; distances are then measured in double, so that the answer does not depend on its
// build.
class TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh) : mesh_(mesh) {
    const Bounds bounds = mesh_bounds(mesh);
    centre_ = 0.5 * (bounds.lower + bounds.upper);
    const double extent = glm::length(bounds.upper - bounds.lower);
    scale_ = extent > 0.0 ? 1.0 / extent : 1.0;
    device_.reset(rtcNewDevice(nullptr));
    if (!device_) throw std::runtime_error("Embree found no usable instruction set");
    RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
    if (vertex == nullptr || index == nullptr) throw std::bad_alloc();
    for (const glm::dvec3& position : mesh.positions) {
      const glm::dvec3 p = scaled(position);
      for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>(p[k]);
    }
    for (const glm::uvec3& t : mesh.triangles)
      for (int k = 0; k < 3; ++k) *index++ = t[k];
    rtcCommitGeometry(geometry);
    scene_.reset(rtcNewScene(device_.get()));
    rtcAttachGeometry(scene_.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_.get());
  }

  struct Hit {
    std::uint32_t triangle = 0;
    glm::dvec3 point{0.0};
    double distance = std::numeric_limits<double>::infinity();
  };

  // The nearest point of the mesh; of equally near triangles the one of lowest index.
  Hit nearest(glm::dvec3 point) const {
    Query query{this, point, {}};
    // From far outside, single precision would overflow: the direction is what counts then.
    const double away = glm::length(point - centre_) * scale_;
    const double near = std::min(1.0, 1e3 / std::max(away, 1.0));
    const glm::dvec3 p = (point - centre_) * near * scale_;
    query.point = centre_ + (point - centre_) * near;
    RTCPointQuery embree{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 0.0f,
                         std::numeric_limits<float>::infinity()};
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_.get(), &embree, &context, visit, &query);
    query.best.distance = glm::length(point - query.best.point);
    return query.best;
  }

 private:
  struct Query {
    const TriangleTree* tree;
    glm::dvec3 point;
    Hit best;
  };

  static bool visit(RTCPointQueryFunctionArguments* arguments) {
    Query& query = *static_cast<Query*>(arguments->userPtr);
    const std::uint32_t t = arguments->primID;
    const Mesh& mesh = query.tree->mesh_;
    const glm::dvec3 on =
        nearest_on_triangle(query.point, mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    const double distance = glm::length(query.point - on);
    if (distance < query.best.distance || (distance == query.best.distance && t < query.best.triangle)) {
      query.best = {t, on, distance};
      // Wide enough that rounding to float hides no triangle that is as near.
      const double radius = distance * query.tree->scale_ * (1.0 + 1e-5) + 1e-6;
      arguments->query->radius = std::min(arguments->query->radius, static_cast<float>(radius));
      return true;
    }
    return false;
  }

  glm::dvec3 scaled(glm::dvec3 p) const { return (p - centre_) * scale_; }

  struct Release {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  const Mesh& mesh_;
  glm::dvec3 centre_;
  double scale_ = 1.0;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace

std::vector<LocatedCell> locate(const Surface& surface, std::span<const glm::dvec3> points) {
  if (surface.owned_count() == 0)
    throw InputError("cell size", "the surface owns no cell: every triangle is smaller than a cell",
                     "use smaller cells");
  const TriangleTree tree(surface.mesh());
  const PatchRows rows{surface.rows(), surface.row_begins(), surface.owned_runs(), surface.cell_size()};
  const Unfolding unfolding(surface.frames(), surface.adjacency());

  std::vector<LocatedCell> cells;
  cells.reserve(points.size());
  for (const glm::dvec3& point : points) {
    const TriangleTree::Hit hit = tree.nearest(point);
    const glm::dvec2 p = surface.frame(hit.triangle).to_plane(hit.point);
    std::optional<NearestCell> cell;
    // Triangles below the cell size may own nothing for a while around: look farther each time.
    for (double reach = 2.5; !cell && reach < 1e6; reach *= 4.0)
      cell = nearest_cell(rows, unfolding, hit.triangle, p, no_patch, reach, std::size_t{1} << 16);
    if (!cell)
      throw InputError("",
                       "no cell near the point (" + std::to_string(point.x) + ", " + std::to_string(point.y) +
                           ", " + std::to_string(point.z) + "): the triangles there are smaller than a cell",
                       "use smaller cells, or move the point");
    cells.push_back({cell->slot, hit.distance});
  }
  return cells;
}

}  // namespace verdigris
