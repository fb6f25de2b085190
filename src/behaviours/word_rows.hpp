#pragma once
// Eight rows of a word column as one vector, and what bit-sliced counting does with it. Compilers split it
// where vectors are shorter; where they are as wide, the instructions that compilers do not find are named.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#ifdef __AVX512F__
#include <immintrin.h>
// g++ 12 warns of its own header (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif

namespace verdigris {

typedef std::uint64_t Rows __attribute__((vector_size(64)));  // NOLINT(modernize-use-using)

inline Rows load(const std::uint64_t* words) {
  Rows rows;
  std::memcpy(&rows, words, sizeof rows);
  return rows;
}
inline void store(std::uint64_t* words, Rows rows) {
  std::memcpy(words, &rows, sizeof rows);
}

// The first `count` of eight words where there are no more; the others are 0, or stay as they are.
inline Rows load_some(const std::uint64_t* words, std::size_t count) {
  if (count >= 8) return load(words);
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(_mm512_maskz_loadu_epi64(static_cast<__mmask8>((1u << count) - 1), words));
#else
  Rows rows{};
  for (std::size_t k = 0; k < count; ++k) rows[k] = words[k];
  return rows;
#endif
}
inline void store_some(std::uint64_t* words, Rows rows, std::size_t count) {
  if (count >= 8) return store(words, rows);
#ifdef __AVX512F__
  _mm512_mask_storeu_epi64(words, static_cast<__mmask8>((1u << count) - 1), reinterpret_cast<__m512i>(rows));
#else
  for (std::size_t k = 0; k < count; ++k) words[k] = rows[k];
#endif
}

// Bitwise functions of three.
inline Rows parity(Rows a, Rows b, Rows c) {
  return a ^ b ^ c;
}
inline Rows majority(Rows a, Rows b, Rows c) {
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(_mm512_ternarylogic_epi64(
      reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b), reinterpret_cast<__m512i>(c), 0xE8));
#else
  return (a & b) | (c & (a ^ b));
#endif
}
inline Rows choose(Rows which, Rows if_one, Rows if_zero) {
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(_mm512_ternarylogic_epi64(reinterpret_cast<__m512i>(which),
                                                          reinterpret_cast<__m512i>(if_one),
                                                          reinterpret_cast<__m512i>(if_zero), 0xCA));
#else
  return if_zero ^ (which & (if_zero ^ if_one));
#endif
}

// Each cell's neighbour along the row: the one to the left, with the word column on the left; to the right.
inline Rows left_of(Rows words, Rows left) {
#ifdef __AVX512VBMI2__
  return reinterpret_cast<Rows>(
      _mm512_shldi_epi64(reinterpret_cast<__m512i>(words), reinterpret_cast<__m512i>(left), 1));
#else
  return words << 1 | left >> 63;
#endif
}
inline Rows right_of(Rows words, Rows right) {
#ifdef __AVX512VBMI2__
  return reinterpret_cast<Rows>(
      _mm512_shrdi_epi64(reinterpret_cast<__m512i>(words), reinterpret_cast<__m512i>(right), 1));
#else
  return words >> 1 | right << 63;
#endif
}

// The rows below those of `here`, the last of `previous` first; the rows above.
inline Rows one_down(Rows previous, Rows here) {
  return __builtin_shufflevector(previous, here, 7, 8, 9, 10, 11, 12, 13, 14);
}
inline Rows one_up(Rows here, Rows next) {
  return __builtin_shufflevector(here, next, 1, 2, 3, 4, 5, 6, 7, 8);
}

// Eight bytes as eight numbers.
inline Rows widened(const std::uint8_t (&bytes)[8]) {
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(
      _mm512_cvtepu8_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(bytes))));
#else
  Rows eight;
  for (unsigned k = 0; k < 8; ++k) eight[k] = bytes[k];
  return eight;
#endif
}
// In each word ones from a bit on; none from bit 64 on.
inline Rows ones_from(const std::uint8_t (&bits)[8]) {
  const Rows by = widened(bits);
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(_mm512_sllv_epi64(_mm512_set1_epi64(-1), reinterpret_cast<__m512i>(by)));
#else
  return (~Rows{} << (by & 63)) & reinterpret_cast<Rows>(by < 64);
#endif
}
// One word turned left by eight numbers of bits below 64.
inline Rows turned_left(std::uint64_t word, const std::uint8_t (&bits)[8]) {
  const Rows by = widened(bits);
#ifdef __AVX512F__
  return reinterpret_cast<Rows>(
      _mm512_rolv_epi64(_mm512_set1_epi64(static_cast<long long>(word)), reinterpret_cast<__m512i>(by)));
#else
  const Rows all = Rows{} + word;
  return all << by | all >> ((64 - by) & 63);
#endif
}

// How many bits of each word are ones.
inline Rows ones_in(Rows rows) {
#ifdef __AVX512VPOPCNTDQ__
  return reinterpret_cast<Rows>(_mm512_popcnt_epi64(reinterpret_cast<__m512i>(rows)));
#else
  for (unsigned k = 0; k < 8; ++k) rows[k] = static_cast<std::uint64_t>(__builtin_popcountll(rows[k]));
  return rows;
#endif
}

// Words of one thread, beginning where a vector may.
class WordRoom {
 public:
  explicit WordRoom(std::size_t words) : eights_(words / 8 + 1) {}
  std::uint64_t* words() { return eights_.data()->word; }

 private:
  struct alignas(64) Eight {
    std::uint64_t word[8] = {};
  };
  std::vector<Eight> eights_;
};

}  // namespace verdigris
