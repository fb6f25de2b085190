#include "verdigris/automaton/bit_sources.hpp"

#include <algorithm>
#include <cstring>

#include "verdigris/base/large_memory.hpp"

#ifdef __AVX512F__
#include <immintrin.h>
// g++ 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace verdigris {

namespace {

constexpr std::size_t block = 16;  // ghosts gathered at a time

#ifdef __AVX512F__
std::uint16_t bits_at(__m512i bits, const std::uint64_t* state) {
  const __m512i words = _mm512_i32gather_epi32(_mm512_srli_epi32(bits, 5), state, 4);
  // Turned left by 31 less its number a bit becomes the sign.
  const __m512i signs = _mm512_rolv_epi32(words, _mm512_andnot_si512(bits, _mm512_set1_epi32(31)));
  return static_cast<std::uint16_t>(_mm512_cmplt_epi32_mask(signs, _mm512_setzero_si512()));
}
#else
template <typename BitOf>
std::uint16_t bits_at(BitOf&& bit_of, const std::uint64_t* state) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < block; ++k) {
    const std::uint32_t bit = bit_of(k);
    bits |= ((state[bit >> 6] >> (bit & 63)) & 1) << k;
  }
  return static_cast<std::uint16_t>(bits);
}
#endif

std::size_t whole_blocks(std::size_t ghosts) {
  return (ghosts + block - 1) / block * block;
}

}  // namespace

bool BitSources::add_near(std::span<const std::uint32_t> sources) {
  std::vector<std::uint32_t> ascending(sources.begin(), sources.end());
  std::sort(ascending.begin(), ascending.end());
  std::vector<std::uint32_t> windows;
  for (const std::uint32_t source : ascending)
    if (windows.empty() || (source - windows.back()) >> window_bits != 0) {
      if (windows.size() == most_windows) return false;
      windows.push_back(source);
    }
  for (const std::uint32_t source : sources) {
    const auto window = std::prev(std::upper_bound(windows.begin(), windows.end(), source));
    near_.push_back(static_cast<std::uint16_t>((window - windows.begin()) << window_bits |
                                               static_cast<std::ptrdiff_t>(source - *window)));
  }
  near_.resize(whole_blocks(near_.size()), 0);
  windows_.insert(windows_.end(), windows.begin(), windows.end());
  return true;
}

void BitSources::add_patch(std::span<const std::uint32_t> sources) {
  Patch& patch = patches_.back();
  const std::size_t near_begin = near_.size(), far_begin = far_.size();
  const bool near = add_near(sources);
  patch.source_begin = static_cast<std::uint32_t>(near ? near_begin : far_begin);
  if (!near) {
    far_.insert(far_.end(), sources.begin(), sources.end());
    far_.resize(whole_blocks(far_.size()), sources.front());
  }
  const auto ghosts = static_cast<std::uint32_t>(whole_blocks(sources.size()));
  patches_.push_back({patch.ghost_begin + ghosts, 0, static_cast<std::uint32_t>(windows_.size())});
}

void BitSources::settle() {
  patches_ = large_copy(patches_);
  windows_ = large_copy(windows_);
  near_ = large_copy(near_);
  far_ = large_copy(far_);
}

void BitSources::gather(std::size_t first_patch, std::size_t last_patch, const std::uint64_t* state,
                        std::uint64_t* stream) const {
  auto* out = reinterpret_cast<unsigned char*>(stream);
  for (std::size_t p = first_patch; p < last_patch; ++p) {
    const Patch &patch = patches_[p], &next = patches_[p + 1];
    const std::uint32_t count = next.ghost_begin - patch.ghost_begin;
    if (count == 0) continue;
    unsigned char* to = out + patch.ghost_begin / 8;
    const auto put = [&](std::uint32_t k, std::uint16_t bits) {
      std::memcpy(to + k / 8, &bits, sizeof bits);
    };
    if (patch.window_begin == next.window_begin) {
      const std::uint32_t* far = far_.data() + patch.source_begin;
      for (std::uint32_t k = 0; k < count; k += block)
#ifdef __AVX512F__
        put(k, bits_at(_mm512_loadu_si512(far + k), state));
#else
        put(k, bits_at([&](std::size_t j) { return far[k + j]; }, state));
#endif
      continue;
    }
    const std::uint16_t* near = near_.data() + patch.source_begin;
    const std::uint32_t* windows = windows_.data() + patch.window_begin;
    constexpr std::uint32_t in_window = (1u << window_bits) - 1;
#ifdef __AVX512F__
    const __m512i bases = _mm512_maskz_loadu_epi32(
        static_cast<__mmask16>((1u << (next.window_begin - patch.window_begin)) - 1), windows);
    for (std::uint32_t k = 0; k < count; k += block) {
      const __m512i source =
          _mm512_cvtepu16_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(near + k)));
      const __m512i base = _mm512_permutexvar_epi32(_mm512_srli_epi32(source, window_bits), bases);
      const __m512i bit = _mm512_and_si512(source, _mm512_set1_epi32(in_window));
      put(k, bits_at(_mm512_add_epi32(base, bit), state));
    }
#else
    for (std::uint32_t k = 0; k < count; k += block)
      put(k,
          bits_at(
              [&](std::size_t j) { return windows[near[k + j] >> window_bits] + (near[k + j] & in_window); },
              state));
#endif
  }
}

std::size_t BitSources::bytes() const {
  return patches_.size() * sizeof(Patch) + windows_.size() * 4 + near_.size() * 2 + far_.size() * 4;
}

}  // namespace verdigris
