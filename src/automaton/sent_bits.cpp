#include "verdigris/automaton/sent_bits.hpp"

#include <algorithm>
#include <cstring>

#include "verdigris/base/large_memory.hpp"

#ifdef __AVX512BW__
#include <immintrin.h>
// g++ 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace verdigris {

namespace {

constexpr std::size_t block = 16;  // bits gathered at a time

// Sixteen numbers of 12, 16 or 32 bits, the lowest bits first.
constexpr std::size_t block_bytes(unsigned width) {
  return block * width / 8;
}

#ifdef __AVX512BW__
template <unsigned width>
__m512i sixteen(const std::uint8_t* from) {
  if constexpr (width == 32) return _mm512_loadu_si512(from);
  const __m256i packed = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  if constexpr (width == 16) return _mm512_cvtepu16_epi32(packed);
  // Each gets the two halves of a word that its bits lie in.
  const __m512i halves =
      _mm512_setr_epi32(0x10000, 0x10000, 0x20001, 0x30002, 0x40003, 0x40003, 0x50004, 0x60005, 0x70006,
                        0x70006, 0x80007, 0x90008, 0xA0009, 0xA0009, 0xB000A, 0xC000B);
  const __m512i shifts = _mm512_setr_epi32(0, 12, 8, 4, 0, 12, 8, 4, 0, 12, 8, 4, 0, 12, 8, 4);
  return _mm512_and_si512(
      _mm512_srlv_epi32(_mm512_permutexvar_epi16(halves, _mm512_castsi256_si512(packed)), shifts),
      _mm512_set1_epi32(0xFFF));
}
template <unsigned width>
std::uint16_t bits_at(const std::uint8_t* from, const std::uint64_t* words) {
  const __m512i bits = sixteen<width>(from);
  const __m512i halves = _mm512_i32gather_epi32(_mm512_srli_epi32(bits, 5), words, 4);
  // Turned left by 31 less its number a bit becomes the sign.
  const __m512i signs = _mm512_rolv_epi32(halves, _mm512_andnot_si512(bits, _mm512_set1_epi32(31)));
  return static_cast<std::uint16_t>(_mm512_cmplt_epi32_mask(signs, _mm512_setzero_si512()));
}
#else
template <unsigned width>
std::uint32_t number(const std::uint8_t* from, std::size_t k) {
  std::uint32_t bytes;
  std::memcpy(&bytes, from + k * width / 8, sizeof bytes);
  if constexpr (width == 32) return bytes;
  return bytes >> (k * width % 8) & (~0u >> (32 - width));
}
template <unsigned width>
std::uint16_t bits_at(const std::uint8_t* from, const std::uint64_t* words) {
  std::uint64_t bits = 0;
  for (std::size_t k = 0; k < block; ++k) {
    const std::uint32_t bit = number<width>(from, k);
    bits |= ((words[bit >> 6] >> (bit & 63)) & 1) << k;
  }
  return static_cast<std::uint16_t>(bits);
}
#endif

template <unsigned width>
void gather_bits(const std::uint8_t* from, std::size_t blocks, const std::uint64_t* words,
                 unsigned char* to) {
  for (std::size_t k = 0; k < blocks; ++k) {
    const std::uint16_t bits = bits_at<width>(from + k * block_bytes(width), words);
    std::memcpy(to + 2 * k, &bits, sizeof bits);
  }
}

// What is read beyond the last numbers.
constexpr std::size_t spare = 16;

}  // namespace

void SentBits::add_patch(std::span<const std::uint32_t> bits) {
  const std::size_t blocks = (bits.size() + block - 1) / block;
  const std::uint32_t most = bits.empty() ? 0 : *std::max_element(bits.begin(), bits.end());
  const unsigned width = most >> 12 == 0 ? 12 : most >> 16 == 0 ? 16 : 32;
  const std::size_t from = numbers_.size();
  numbers_.resize(from + blocks * block_bytes(width), 0);
  for (std::size_t k = 0; k < bits.size(); ++k)
    for (unsigned bit = 0; bit < width; ++bit) {
      const std::size_t at = k * width + bit;
      numbers_[from + at / 8] |= static_cast<std::uint8_t>((bits[k] >> bit & 1u) << at % 8);
    }
  patches_.push_back({patches_.back().stream_begin + static_cast<std::uint32_t>(blocks * block),
                      static_cast<std::uint32_t>(numbers_.size() / 8)});
}

void SentBits::settle() {
  patches_ = large_copy(patches_);
  numbers_.resize(numbers_.size() + spare, 0);
  numbers_ = large_copy(numbers_);
}

void SentBits::gather(std::size_t patch, const std::uint64_t* words, std::uint64_t* stream) const {
  const Patch &here = patches_[patch], &next = patches_[patch + 1];
  const std::size_t blocks = (next.stream_begin - here.stream_begin) / block,
                    bytes = std::size_t{8} * (next.from - here.from);
  const std::uint8_t* from = numbers_.data() + std::size_t{8} * here.from;
  unsigned char* to = reinterpret_cast<unsigned char*>(stream) + here.stream_begin / 8;
  if (bytes == blocks * block_bytes(12))
    gather_bits<12>(from, blocks, words, to);
  else if (bytes == blocks * block_bytes(16))
    gather_bits<16>(from, blocks, words, to);
  else
    gather_bits<32>(from, blocks, words, to);
}

std::size_t SentBits::bytes() const {
  return patches_.size() * sizeof(Patch) + numbers_.size();
}

}  // namespace verdigris
