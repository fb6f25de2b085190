#include "ray_scene.hpp"

#include <embree3/rtcore.h>

#include <glm/geometric.hpp>
#include <limits>
#include <new>
#include <stdexcept>

namespace verdigris {

struct RayScene::Tree {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Tree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

void RayScene::Release::operator()(Tree* tree) const {
  delete tree;
}

RayScene::RayScene(const Mesh& mesh) : mesh_(mesh), tree_(new Tree) {
  const Bounds bounds = mesh_bounds(mesh);
  centre_ = 0.5 * (bounds.lower + bounds.upper);
  const double diagonal = glm::length(bounds.upper - bounds.lower);
  scale_ = diagonal > 0.0 ? 1.0 / diagonal : 1.0;
  tree_->device = rtcNewDevice(nullptr);
  if (tree_->device == nullptr) throw std::runtime_error("Embree found no usable instruction set");
  RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
  if (vertex == nullptr || index == nullptr) throw std::bad_alloc();
  for (const glm::dvec3& position : mesh.positions)
    for (int k = 0; k < 3; ++k) *vertex++ = static_cast<float>((position[k] - centre_[k]) * scale_);
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) *index++ = t[k];
  rtcCommitGeometry(geometry);
  tree_->scene = rtcNewScene(tree_->device);
  // Robust: no ray slips through between two triangles.
  rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(tree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree_->scene);
}

namespace {
RTCRay make_ray(glm::dvec3 p, glm::dvec3 d) {
  RTCRay ray{};
  ray.org_x = static_cast<float>(p.x);
  ray.org_y = static_cast<float>(p.y);
  ray.org_z = static_cast<float>(p.z);
  ray.dir_x = static_cast<float>(d.x);
  ray.dir_y = static_cast<float>(d.y);
  ray.dir_z = static_cast<float>(d.z);
  ray.tfar = std::numeric_limits<float>::infinity();
  ray.mask = 0xFFFFFFFFu;
  return ray;
}
}  // namespace

bool RayScene::occluded(glm::dvec3 from, glm::dvec3 direction) const {
  RTCRay ray = make_ray((from - centre_) * scale_, direction);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(tree_->scene, &context, &ray);
  return ray.tfar < 0.0f;
}

std::optional<RayScene::Hit> RayScene::first(glm::dvec3 from, glm::dvec3 direction) const {
  RTCRayHit query{make_ray((from - centre_) * scale_, direction), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(tree_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const std::uint32_t t = query.hit.primID;
  const double u = query.hit.u, v = query.hit.v;
  return Hit{t, (1.0 - u - v) * mesh_.corner(t, 0) + u * mesh_.corner(t, 1) + v * mesh_.corner(t, 2)};
}

}  // namespace verdigris
