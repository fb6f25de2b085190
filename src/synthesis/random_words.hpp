#pragma once
// Random numbers that depend on nothing but what they are for.

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace verdigris::synthesis {

/// Four independent uniform words for one purpose: Philox4x32 with 7 rounds (Salmon et al. 2011), as cells
/// have them.
inline std::array<std::uint32_t, 4> random_words(std::uint64_t seed, std::uint32_t a, std::uint32_t b,
                                                 std::uint32_t c, std::uint32_t d = 0) {
  using Philox = r123::Philox4x32_R<7>;
  Philox::key_type key{};
  key[0] = static_cast<std::uint32_t>(seed);
  key[1] = static_cast<std::uint32_t>(seed >> 32);
  Philox::ctr_type counter{};
  counter[0] = a;
  counter[1] = b;
  counter[2] = c;
  counter[3] = d;
  const Philox::ctr_type word = Philox()(counter, key);
  return {word[0], word[1], word[2], word[3]};
}

/// A deviate of mean 0 and variance 1: the sum of eight uniform ones, which is normal for all but its tails
/// (it ends at 4.9) and needs no function whose last bits differ between mathematics libraries.
inline double random_deviate(const std::array<std::uint32_t, 4>& words) {
  std::int64_t sum = 0;
  for (const std::uint32_t word : words)
    sum += static_cast<std::int64_t>(word & 0xFFFFu) + static_cast<std::int64_t>(word >> 16);
  constexpr double scale = 1.0 / 65536.0, deviation = 0.816496580927726;  // sqrt(8 / 12)
  return (static_cast<double>(sum) * scale + 4.0 * scale - 4.0) / deviation;
}

}  // namespace verdigris::synthesis
