#include "triangle_set.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>

namespace verdigris {

namespace {

std::array<std::uint32_t, 3> sorted(const glm::uvec3& t) {
  std::array<std::uint32_t, 3> key{t.x, t.y, t.z};
  std::sort(key.begin(), key.end());
  return key;
}

}  // namespace

std::vector<bool> duplicate_triangles(const Mesh& mesh) {
  constexpr std::uint32_t empty = 0xFFFFFFFFu;
  const std::size_t count = mesh.triangles.size();
  std::vector<std::uint32_t> slots(std::bit_ceil(std::max<std::size_t>(2 * count, 16)), empty);
  std::vector<bool> duplicate(count, false);
  for (std::size_t t = 0; t < count; ++t) {
    const auto key = sorted(mesh.triangles[t]);
    std::size_t slot = static_cast<std::size_t>(XXH3_64bits(key.data(), sizeof key)) & (slots.size() - 1);
    while (slots[slot] != empty && sorted(mesh.triangles[slots[slot]]) != key)
      slot = (slot + 1) & (slots.size() - 1);
    if (slots[slot] == empty)
      slots[slot] = static_cast<std::uint32_t>(t);
    else
      duplicate[t] = true;
  }
  return duplicate;
}

}  // namespace verdigris
