#include "verdigris/mesh/mesh.hpp"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <span>

namespace verdigris {

namespace {

constexpr std::uint32_t empty_slot = 0xFFFFFFFFu;

/// Open-addressing table from a position to the first vertex that had it.
class PositionTable {
 public:
  explicit PositionTable(std::size_t vertices)
      : slots_(std::bit_ceil(std::max<std::size_t>(2 * vertices, 16)), empty_slot) {}

  /// The number of an earlier vertex at `p`, or `fresh`, which is then remembered.
  std::uint32_t find_or_add(const glm::dvec3& p, std::uint32_t fresh, std::span<const glm::dvec3> kept) {
    const double key[3] = {p.x + 0.0, p.y + 0.0, p.z + 0.0};  // -0 + 0 = +0: one hash for both zeros
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = static_cast<std::size_t>(XXH3_64bits(key, sizeof key)) & mask;
    while (slots_[slot] != empty_slot) {
      if (kept[slots_[slot]] == p) return slots_[slot];
      slot = (slot + 1) & mask;
    }
    slots_[slot] = fresh;
    return fresh;
  }

 private:
  std::vector<std::uint32_t> slots_;
};

/// Feeds the bytes of 8- or 4-byte words to the hash, the lowest byte first on every machine.
template <class Word>
void hash_words(XXH3_state_t* state, std::span<Word> words) {
  if constexpr (std::endian::native == std::endian::big)
    for (Word& w : words) {
      auto* bytes = reinterpret_cast<unsigned char*>(&w);
      std::reverse(bytes, bytes + sizeof w);
    }
  XXH3_128bits_update(state, words.data(), words.size_bytes());
}

}  // namespace

Mesh weld(const Mesh& mesh, WeldReport* report) {
  Mesh out;
  const std::size_t vertices = mesh.positions.size();
  std::vector<std::uint32_t> target(vertices);
  out.positions.reserve(vertices);
  PositionTable table(vertices);
  for (std::size_t v = 0; v < vertices; ++v) {
    const auto fresh = static_cast<std::uint32_t>(out.positions.size());
    target[v] = table.find_or_add(mesh.positions[v], fresh, out.positions);
    if (target[v] == fresh) out.positions.push_back(mesh.positions[v]);
  }

  out.triangles.reserve(mesh.triangles.size());
  std::vector<std::uint32_t> kept;  // [triangle of out] -> triangle of mesh
  kept.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::uvec3& m = mesh.triangles[t];
    const glm::uvec3 w(target[m.x], target[m.y], target[m.z]);
    if (w.x == w.y || w.y == w.z || w.z == w.x) continue;
    out.triangles.push_back(w);
    kept.push_back(static_cast<std::uint32_t>(t));
  }

  const bool welded = out.positions.size() != vertices;
  const bool dropped = kept.size() != mesh.triangles.size();
  if (!mesh.vertex_of_file.empty()) {
    out.vertex_of_file = mesh.vertex_of_file;
    for (std::uint32_t& v : out.vertex_of_file) v = target[v];
  } else if (welded) {
    out.vertex_of_file = std::move(target);
  }
  if (!dropped) {
    out.corner_uv = mesh.corner_uv;
    out.corner_color = mesh.corner_color;
    out.face_of_triangle = mesh.face_of_triangle;
  } else {
    auto take = [&kept](const auto& from, auto& to, std::size_t per_triangle) {
      if (from.empty()) return;
      to.reserve(per_triangle * kept.size());
      for (const std::uint32_t t : kept)
        for (std::size_t k = 0; k < per_triangle; ++k) to.push_back(from[per_triangle * t + k]);
    };
    take(mesh.corner_uv, out.corner_uv, 3);
    take(mesh.corner_color, out.corner_color, 3);
    take(mesh.face_of_triangle, out.face_of_triangle, 1);
    if (mesh.face_of_triangle.empty()) out.face_of_triangle = kept;
  }
  if (report) {
    report->vertices_welded = vertices - out.positions.size();
    report->collapsed_faces = mesh.triangles.size() - out.triangles.size();
  }
  return out;
}

std::string mesh_hash(const Mesh& mesh) {
  XXH3_state_t* state = XXH3_createState();
  XXH3_128bits_reset(state);
  std::uint64_t counts[2] = {mesh.positions.size(), mesh.triangles.size()};
  hash_words<std::uint64_t>(state, counts);

  constexpr std::size_t block =
      1024;  // through a small buffer: zeros lose their sign, padding cannot leak in
  double xyz[3 * block];
  for (std::size_t from = 0; from < mesh.positions.size(); from += block) {
    const std::size_t n = std::min(block, mesh.positions.size() - from);
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c)
        xyz[3 * i + static_cast<std::size_t>(c)] = mesh.positions[from + i][c] + 0.0;
    hash_words<double>(state, std::span(xyz, 3 * n));
  }
  std::uint32_t abc[3 * block];
  for (std::size_t from = 0; from < mesh.triangles.size(); from += block) {
    const std::size_t n = std::min(block, mesh.triangles.size() - from);
    for (std::size_t i = 0; i < n; ++i)
      for (int c = 0; c < 3; ++c) abc[3 * i + static_cast<std::size_t>(c)] = mesh.triangles[from + i][c];
    hash_words<std::uint32_t>(state, std::span(abc, 3 * n));
  }
  XXH128_canonical_t digest;
  XXH128_canonicalFromHash(&digest, XXH3_128bits_digest(state));
  XXH3_freeState(state);

  constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest.digest) {
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text;
}

double mesh_area(const Mesh& mesh) {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec3& a = mesh.corner(t, 0);
    twice += glm::length(glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a));
  }
  return 0.5 * twice;
}

Bounds mesh_bounds(const Mesh& mesh) {
  Bounds bounds;
  if (mesh.positions.empty()) return bounds;
  bounds.lower = bounds.upper = mesh.positions.front();
  for (const glm::dvec3& p : mesh.positions) {
    bounds.lower = glm::min(bounds.lower, p);
    bounds.upper = glm::max(bounds.upper, p);
  }
  return bounds;
}

}  // namespace verdigris
