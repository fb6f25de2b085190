#include "verdigris/terrain/height_mesh.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace verdigris {

namespace {

// Vertices and those of the walls and the floor are counted in 32 bits.
constexpr std::uint64_t most_heights = 4'000'000'000;

void check(const HeightMap& map) {
  if (map.width > 0 && map.height > 0 &&
      static_cast<std::uint64_t>(map.width) * static_cast<std::uint64_t>(map.height) > most_heights)
    throw std::length_error("a height mesh of more than 4e9 heights");
  if (map.width < 2 || map.height < 2 ||
      map.values.size() != static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height))
    throw std::invalid_argument("a height mesh needs 2 x 2 heights, and as many as its size says");
}

std::uint32_t vertex(const HeightMap& map, int x, int y) {
  return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(map.width) +
         static_cast<std::uint32_t>(x);
}

// Vertices of the border, once around: along the far edge, down the right one, and so on.
std::vector<std::uint32_t> border(const HeightMap& map) {
  std::vector<std::uint32_t> loop;
  const int right = map.width - 1, near = map.height - 1;
  for (int x = 0; x < right; ++x) loop.push_back(vertex(map, x, 0));
  for (int y = 0; y < near; ++y) loop.push_back(vertex(map, right, y));
  for (int x = right; x > 0; --x) loop.push_back(vertex(map, x, near));
  for (int y = near; y > 0; --y) loop.push_back(vertex(map, 0, y));
  return loop;
}

}  // namespace

Mesh height_mesh(const HeightMap& map, double scale) {
  check(map);
  Mesh mesh;
  mesh.positions.reserve(map.values.size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      mesh.positions.emplace_back(x * map.step, scale * static_cast<double>(map.values[vertex(map, x, y)]),
                                  y * map.step);
  const auto apart = [&](std::uint32_t a, std::uint32_t b) {
    return std::fabs(map.values[a] - map.values[b]);
  };
  for (int y = 0; y + 1 < map.height; ++y)
    for (int x = 0; x + 1 < map.width; ++x) {
      const std::uint32_t far_left = vertex(map, x, y), far_right = far_left + 1,
                          near_left = vertex(map, x, y + 1), near_right = near_left + 1;
      if (apart(far_left, near_right) <= apart(far_right, near_left)) {
        mesh.triangles.emplace_back(far_left, near_left, near_right);
        mesh.triangles.emplace_back(far_left, near_right, far_right);
      } else {
        mesh.triangles.emplace_back(far_left, near_left, far_right);
        mesh.triangles.emplace_back(far_right, near_left, near_right);
      }
    }
  return mesh;
}

Mesh height_solid(const HeightMap& map, double scale, double base) {
  Mesh mesh = height_mesh(map, scale);
  for (const glm::dvec3& p : mesh.positions)
    if (!(base < p.y)) throw std::invalid_argument("the floor of a solid is not below all its heights");
  const std::vector<std::uint32_t> top = border(map);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const std::uint32_t v : top)
    mesh.positions.emplace_back(mesh.positions[v].x, base, mesh.positions[v].z);
  const auto middle = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.emplace_back(0.5 * map.step * (map.width - 1), base, 0.5 * map.step * (map.height - 1));
  for (std::uint32_t k = 0; k < top.size(); ++k) {
    const auto next = static_cast<std::uint32_t>((k + 1) % top.size());
    const std::uint32_t below = first + k, below_next = first + next;
    mesh.triangles.emplace_back(top[k], top[next], below_next);
    mesh.triangles.emplace_back(top[k], below_next, below);
    mesh.triangles.emplace_back(below, below_next, middle);
  }
  return mesh;
}

}  // namespace verdigris
