#pragma once
// Random numbers that depend on nothing but what they are for: (seed, step, cell, purpose).

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace verdigris {

/// The random numbers of one cell in one step. The same for any number of threads, any order, after a
/// restart.
///
/// Philox4x32 with 7 rounds (Salmon et al. 2011, "Parallel random numbers: as easy as 1, 2, 3": the fewest
/// that pass BigCrush), key = seed, counter = (cell, step, purpose, block).
class CellRandom {
 public:
  CellRandom(std::uint64_t seed, std::uint64_t step, std::uint32_t cell)
      : seed_(seed), step_(step), cell_(cell) {}

  /// Four independent uniform 32-bit words for one purpose. `block` gives four more each time.
  std::array<std::uint32_t, 4> words(std::uint32_t purpose, std::uint32_t block = 0) const {
    using Philox = r123::Philox4x32_R<7>;
    Philox::key_type key{};
    key[0] = static_cast<std::uint32_t>(seed_);
    key[1] = static_cast<std::uint32_t>(seed_ >> 32);
    Philox::ctr_type counter{};
    counter[0] = cell_;
    counter[1] = static_cast<std::uint32_t>(step_);
    // Steps beyond 2^32 would take days; they still get numbers of their own.
    counter[2] = purpose ^ (static_cast<std::uint32_t>(step_ >> 32) << 16);
    counter[3] = block;
    const Philox::ctr_type word = Philox()(counter, key);
    return {word[0], word[1], word[2], word[3]};
  }

  std::uint64_t seed() const { return seed_; }
  std::uint64_t step() const { return step_; }
  std::uint32_t cell() const { return cell_; }

 private:
  std::uint64_t seed_, step_;
  std::uint32_t cell_;
};

/// `word < threshold(p)` holds with probability p, to 2^-32; p is clamped to 0..1. p = 1 always holds.
constexpr std::uint64_t threshold(double p) {
  return p <= 0.0   ? 0
         : p >= 1.0 ? std::uint64_t{1} << 32
                    : static_cast<std::uint64_t>(p * 4294967296.0 + 0.5);
}

}  // namespace verdigris
