#include "rings.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace verdigris::meshes {
namespace {

std::uint32_t add_vertex(Mesh& mesh, const glm::dvec3& position) {
  mesh.positions.push_back(position);
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

}  // namespace

std::uint32_t Ring::at(int i) const {
  const int count = static_cast<int>(vertices.size());
  return vertices[static_cast<std::size_t>((i + count) % count)];
}

std::vector<double> even_angles(int count) {
  std::vector<double> angles;
  for (int i = 0; i <= count / 2; ++i) angles.push_back(2 * std::numbers::pi * i / count);
  return angles;
}

std::vector<double> angles_with_columns(int count, double width) {
  std::vector<double> angles{0.0};
  const int others = count / 2 - 1;
  for (int i = 0; i <= others; ++i) angles.push_back(width + (std::numbers::pi - width) * i / others);
  return angles;
}

Ring add_ring(Mesh& mesh, double radius, double y, std::vector<double> angles) {
  Ring ring{std::move(angles), {}};
  const auto add = [&](double angle) {
    ring.vertices.push_back(add_vertex(mesh, {radius * std::cos(angle), y, -radius * std::sin(angle)}));
  };
  for (const double angle : ring.angles) add(angle);
  for (std::size_t i = ring.angles.size() - 2; i > 0; --i) add(-ring.angles[i]);
  return ring;
}

Ring add_pole(Mesh& mesh, double y) {
  return {{}, {add_vertex(mesh, {0.0, y, 0.0})}};
}

void stitch(Mesh& mesh, const Ring& from, const Ring& to, bool opening) {
  const int from_end = static_cast<int>(from.angles.size()) - 1,
            to_end = static_cast<int>(to.angles.size()) - 1;
  int i = opening ? 1 : 0, j = opening ? 1 : 0;
  // Half way round, always advancing on the ring that is behind; each triangle with its mirror image.
  while (i < from_end || j < to_end) {
    const auto middle = [](const Ring& ring, int k) {
      const auto at = static_cast<std::size_t>(k);
      return ring.angles[at] + ring.angles[at + 1];
    };
    // The margin lets equal angles take the same way whatever the last bit is.
    const bool advance_from = j >= to_end || (i < from_end && middle(from, i) < middle(to, j) + 1e-9);
    if (advance_from) {
      mesh.triangles.emplace_back(from.at(i), from.at(i + 1), to.at(j));
      mesh.triangles.emplace_back(from.at(-i - 1), from.at(-i), to.at(-j));
      ++i;
    } else {
      mesh.triangles.emplace_back(from.at(i), to.at(j + 1), to.at(j));
      mesh.triangles.emplace_back(from.at(-i), to.at(-j), to.at(-j - 1));
      ++j;
    }
  }
}

}  // namespace verdigris::meshes
