#include "thin_out.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace verdigris::meshes {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using Triangles = OpenMesh::TriMesh_ArrayKernelT<Traits>;

}  // namespace

Mesh thin_out(const Mesh& mesh, std::size_t triangles) {
  Triangles work;
  work.request_face_normals();
  std::vector<Triangles::VertexHandle> vertices;
  // To what files hold: which edge goes first must not hang on the last bits of a sine.
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  for (const glm::dvec3& p : mesh.positions)
    vertices.push_back(work.add_vertex({rounded(p.x), rounded(p.y), rounded(p.z)}));
  for (const glm::uvec3& t : mesh.triangles)
    if (!work.add_face(vertices[t.x], vertices[t.y], vertices[t.z]).is_valid())
      throw std::runtime_error("a surface that is no two-manifold");
  work.update_face_normals();

  OpenMesh::Decimater::DecimaterT<Triangles> decimater(work);
  OpenMesh::Decimater::ModQuadricT<Triangles>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<Triangles>::Handle turning;
  OpenMesh::Decimater::ModAspectRatioT<Triangles>::Handle slender;
  decimater.add(quadric);
  decimater.add(turning);
  decimater.add(slender);
  decimater.module(quadric).unset_max_err();
  decimater.module(turning).set_max_normal_deviation(25.0);
  decimater.module(slender).set_aspect_ratio(4.0);
  decimater.initialize();
  decimater.decimate_to_faces(0, triangles);
  work.garbage_collection();

  Mesh thin;
  for (const auto vertex : work.vertices()) {
    const OpenMesh::Vec3d& p = work.point(vertex);
    thin.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto face : work.faces()) {
    glm::uvec3 triangle(0);
    int k = 0;
    for (const auto vertex : work.fv_range(face)) triangle[k++] = static_cast<std::uint32_t>(vertex.idx());
    thin.triangles.push_back(triangle);
  }
  return thin;
}

}  // namespace verdigris::meshes
