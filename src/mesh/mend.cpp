#include "verdigris/mesh/mend.hpp"

#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "bad_edges.hpp"
#include "triangle_set.hpp"

namespace verdigris {

namespace {

constexpr std::uint32_t none = Adjacency::none;

Mesh without_duplicates(const Mesh& mesh, std::size_t& removed) {
  const std::vector<bool> duplicate = duplicate_triangles(mesh);
  Mesh out;
  out.positions = mesh.positions;
  out.vertex_of_file = mesh.vertex_of_file;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (duplicate[t]) {
      ++removed;
      continue;
    }
    out.triangles.push_back(mesh.triangles[t]);
    out.face_of_triangle.push_back(mesh.face_of_triangle.empty() ? t : mesh.face_of_triangle[t]);
    for (std::size_t corner = 3 * std::size_t{t}; corner < 3 * std::size_t{t} + 3; ++corner) {
      if (!mesh.corner_uv.empty()) out.corner_uv.push_back(mesh.corner_uv[corner]);
      if (!mesh.corner_color.empty()) out.corner_color.push_back(mesh.corner_color[corner]);
    }
  }
  if (removed == 0) out.face_of_triangle = mesh.face_of_triangle;
  return out;
}

/// The other way round, with what its corners carry.
void turn(Mesh& mesh, std::size_t t) {
  std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
  if (!mesh.corner_uv.empty()) std::swap(mesh.corner_uv[3 * t + 1], mesh.corner_uv[3 * t + 2]);
  if (!mesh.corner_color.empty()) std::swap(mesh.corner_color[3 * t + 1], mesh.corner_color[3 * t + 2]);
}

/// Triangles that two-triangle edges connect.
struct Component {
  std::vector<std::uint32_t> triangles;
  std::size_t odd = 0;  ///< those that run against the first
  bool orientable = true;
  bool closed = true;
};

class Orienter {
 public:
  Orienter(Mesh& mesh, MendReport& report) : mesh_(mesh), report_(report), adjacency_(make_adjacency(mesh)) {
    links_ = two_sided_links(adjacency_, bad_sides(mesh, adjacency_));
    state_.assign(mesh.triangles.size(), unseen);
  }

  void orient() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
      if (state_[t] == unseen) orient_component(collect(t));
  }

 private:
  enum State : std::uint8_t { even, odd, unseen };

  Component collect(std::uint32_t first) {
    Component component;
    component.triangles.push_back(first);
    state_[first] = even;
    for (std::size_t i = 0; i < component.triangles.size(); ++i) {
      const std::uint32_t t = component.triangles[i];
      component.odd += state_[t] == odd;
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (links_[h] == none) {
          component.closed = false;
          continue;
        }
        const bool differs = adjacency_.kind[h] == EdgeKind::inconsistent;
        const State wanted = (state_[t] == odd) != differs ? odd : even;
        State& other = state_[links_[h] / 3];
        if (other == unseen) {
          other = wanted;
          component.triangles.push_back(links_[h] / 3);
        } else if (other != wanted) {
          component.orientable = false;
        }
      }
    }
    return component;
  }

  void orient_component(const Component& component) {
    if (!component.orientable) {
      ++report_.unorientable_components;
      return;
    }
    if (component.odd == 0) return;
    State minority = 2 * component.odd <= component.triangles.size() ? odd : even;
    for (const std::uint32_t t : component.triangles)
      if (state_[t] == minority) turn(mesh_, t);
    if (component.closed && volume(component) < 0.0) {
      for (const std::uint32_t t : component.triangles) turn(mesh_, t);
      minority = minority == odd ? even : odd;
    }
    report_.triangles_flipped += minority == odd ? component.odd : component.triangles.size() - component.odd;
  }

  /// Six times the signed volume, about a point of the component so that a far origin costs no digits.
  double volume(const Component& component) const {
    const glm::dvec3 origin = mesh_.corner(component.triangles.front(), 0);
    double sum = 0.0;
    for (const std::uint32_t t : component.triangles)
      sum += glm::dot(mesh_.corner(t, 0) - origin,
                      glm::cross(mesh_.corner(t, 1) - origin, mesh_.corner(t, 2) - origin));
    return sum;
  }

  Mesh& mesh_;
  MendReport& report_;
  Adjacency adjacency_;
  std::vector<std::uint32_t> links_;
  std::vector<State> state_;
};

}  // namespace

Mesh mend(const Mesh& mesh, MendReport* report) {
  MendReport found;
  Mesh out = without_duplicates(mesh, found.duplicates_removed);
  Orienter(out, found).orient();
  if (report) *report = found;
  return out;
}

}  // namespace verdigris
