#include "pair_sort.hpp"

#include <array>
#include <cstddef>

namespace verdigris {

void sort_by_source(std::vector<std::uint64_t>& pairs, std::uint64_t source_count) {
  constexpr unsigned digit_bits = 11;
  constexpr std::uint64_t mask = (1u << digit_bits) - 1;
  std::vector<std::uint64_t> other(pairs.size());
  for (unsigned shift = 32; shift < 64 && (source_count >> (shift - 32)) != 0; shift += digit_bits) {
    std::array<std::size_t, mask + 2> start{};
    for (const std::uint64_t pair : pairs) ++start[((pair >> shift) & mask) + 1];
    for (std::size_t digit = 1; digit < start.size(); ++digit) start[digit] += start[digit - 1];
    for (const std::uint64_t pair : pairs) other[start[(pair >> shift) & mask]++] = pair;
    pairs.swap(other);
  }
}

}  // namespace verdigris
