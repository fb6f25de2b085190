// Longest-edge bisection: Rivara 1984, "Algorithms for refining triangular grids suitable for adaptive and
// multigrid techniques".

#include "sample_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>
#include <unordered_map>

namespace verdigris {

namespace {

// Corners of the mesh that are one sample.
class CornerSets {
 public:
  explicit CornerSets(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return c;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);  // the lowest corner stands for all
  }

 private:
  std::vector<std::uint32_t> parent_;
};

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

double angle_at(const Mesh& mesh, std::uint32_t corner) {
  const std::size_t t = corner / 3;
  const int k = static_cast<int>(corner % 3);
  const glm::dvec3 p = mesh.corner(t, k), a = mesh.corner(t, (k + 1) % 3) - p,
                   b = mesh.corner(t, (k + 2) % 3) - p;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

SampleMesh::SampleMesh(const Surface& surface, double crease_angle) {
  const Mesh& mesh = surface.mesh();
  const auto corners = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  const auto& opposite = surface.adjacency().opposite;
  const double least_cosine = std::cos(std::min(crease_angle, 180.0) * std::numbers::pi / 180.0) - 1e-9;
  const auto normal = [&](std::uint32_t t) {
    return surface.frame(t).cy > 0.0 ? surface.frame(t).normal() : glm::dvec3(0.0);
  };
  const auto vertex = [&](std::uint32_t c) { return mesh.triangles[c / 3][c % 3]; };
  const auto after = [](std::uint32_t c) { return c % 3 == 2 ? c - 2 : c + 1; };
  CornerSets sets(corners);
  for (std::uint32_t e = 0; e < corners; ++e) {
    const std::uint32_t o = opposite[e];
    if (o == Adjacency::none || o < e) continue;
    const glm::dvec3 a = normal(e / 3), b = normal(o / 3);
    if (a != glm::dvec3(0.0) && b != glm::dvec3(0.0) && glm::dot(a, b) < least_cosine) continue;
    // Links need not follow from the vertices (a periodic surface): those are places of their own.
    if (vertex(e) == vertex(after(o))) sets.join(e, after(o));
    if (vertex(o) == vertex(after(e))) sets.join(o, after(e));
  }
  std::vector<std::uint32_t> sample_of(corners, none);
  for (std::uint32_t c = 0; c < corners; ++c) {
    const std::uint32_t first = sets.find(c);
    if (first == c) {
      sample_of[c] = static_cast<std::uint32_t>(samples_.size());
      samples_.push_back({mesh.positions[vertex(c)], glm::dvec3(0.0), glm::dvec3(0.0), {none, none}});
    }
    sample_of[c] = sample_of[first];
    Sample& s = samples_[sample_of[c]];
    s.normal += angle_at(mesh, c) * normal(c / 3);
    s.inward += (mesh.corner(c / 3, 0) + mesh.corner(c / 3, 1) + mesh.corner(c / 3, 2)) / 3.0 - s.position;
  }
  for (Sample& s : samples_) {
    const double length = glm::length(s.normal);
    s.normal = length > 1e-9 ? s.normal / length : glm::dvec3(0.0, 0.0, 1.0);
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    pieces_.push_back({{sample_of[3 * t], sample_of[3 * t + 1], sample_of[3 * t + 2]}, t});
}

double SampleMesh::edge_length(std::uint32_t a, std::uint32_t b) const {
  return glm::length(samples_[a].position - samples_[b].position);
}

std::size_t SampleMesh::refine(const std::function<bool(std::uint32_t, std::uint32_t)>& split) {
  const std::size_t before = samples_.size();
  std::unordered_map<std::uint64_t, std::uint32_t> middle;  // [edge] sample, or none while only marked
  std::vector<std::uint64_t> marked;                        // in order of marking
  const auto mark = [&](std::uint32_t a, std::uint32_t b) {
    if (middle.try_emplace(edge_key(a, b), none).second) marked.push_back(edge_key(a, b));
  };
  const auto is_marked = [&](std::uint32_t a, std::uint32_t b) { return middle.contains(edge_key(a, b)); };
  // Of equals the one of lower samples: both sides must agree.
  const auto longest = [&](const Piece& p) {
    int best = 0;
    const auto rank = [&](int k) {
      const std::uint32_t a = p.samples[k], b = p.samples[(k + 1) % 3];
      return std::pair(edge_length(std::min(a, b), std::max(a, b)), ~edge_key(a, b));
    };
    for (int k = 1; k < 3; ++k)
      if (rank(k) > rank(best)) best = k;
    return best;
  };
  for (const Piece& p : pieces_)
    for (int k = 0; k < 3; ++k)
      if (split(p.samples[k], p.samples[(k + 1) % 3])) mark(p.samples[k], p.samples[(k + 1) % 3]);
  if (marked.empty()) return 0;
  for (bool again = true; again;) {
    again = false;
    for (const Piece& p : pieces_) {
      bool any = false;
      for (int k = 0; k < 3; ++k) any = any || is_marked(p.samples[k], p.samples[(k + 1) % 3]);
      if (!any) continue;
      const int k = longest(p);
      if (is_marked(p.samples[k], p.samples[(k + 1) % 3])) continue;
      mark(p.samples[k], p.samples[(k + 1) % 3]);
      again = true;
    }
  }
  for (const std::uint64_t key : marked) {
    const Sample &a = samples_[key >> 32], &b = samples_[key & none];
    const glm::dvec3 sum = a.normal + b.normal;
    const double length = glm::length(sum);
    middle[key] = static_cast<std::uint32_t>(samples_.size());
    samples_.push_back({0.5 * (a.position + b.position),
                        length > 1e-9 ? sum / length : a.normal,
                        glm::dvec3(0.0),
                        {none, none}});
  }
  std::vector<Piece> pieces;
  pieces.reserve(pieces_.size() + 3 * marked.size());
  // Cuts a piece at its longest edge, then the halves at what is marked of theirs: at most four.
  const auto cut = [&](const Piece& p, auto&& self, int depth) -> void {
    int k = -1;
    if (depth == 0) {
      k = longest(p);
      if (!is_marked(p.samples[k], p.samples[(k + 1) % 3])) k = -1;
    } else {
      for (int j = 0; j < 3 && k < 0; ++j)
        if (is_marked(p.samples[j], p.samples[(j + 1) % 3])) k = j;
    }
    if (k < 0) {
      pieces.push_back(p);
      return;
    }
    const std::uint32_t a = p.samples[k], b = p.samples[(k + 1) % 3], c = p.samples[(k + 2) % 3];
    const std::uint32_t m = middle.at(edge_key(a, b));
    Sample& s = samples_[m];
    s.inward += samples_[c].position - s.position;
    if (s.faces[0] == none || s.faces[0] == p.patch)
      s.faces[0] = p.patch;
    else
      s.faces[1] = p.patch;
    self({{a, m, c}, p.patch}, self, depth + 1);
    self({{m, b, c}, p.patch}, self, depth + 1);
  };
  for (const Piece& p : pieces_) cut(p, cut, 0);
  pieces_ = std::move(pieces);
  return samples_.size() - before;
}

void SampleMesh::refine_to(double length) {
  while (refine([&](std::uint32_t a, std::uint32_t b) { return edge_length(a, b) > length; }) > 0) {
  }
}

}  // namespace verdigris
