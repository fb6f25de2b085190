#pragma once

#include <cstdint>

namespace verdigris::meshes {

/// Well mixed 32 bits of a place, so that shapes depend on no library's random numbers. The mixer is the
/// finaliser of MurmurHash3 (Appleby, public domain).
constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = seed;
  for (const std::uint32_t value : {x, y}) {
    h ^= value + 0x9e3779b9u;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
  }
  return h;
}

}  // namespace verdigris::meshes
