#include "verdigris/surface/links.hpp"

#include "verdigris/base/large_memory.hpp"

namespace verdigris {

Links::Links(std::size_t slot_count, std::span<const std::uint64_t> sorted_pairs)
    : bits_(large_vector(slot_count / 64 + 1, std::uint64_t{0})),
      rank_(large_vector(slot_count / 64 + 1, std::uint32_t{0})) {
  reserve_large(targets_, sorted_pairs.size());
  std::size_t sources = 0;
  for (std::size_t k = 0; k < sorted_pairs.size(); ++k)
    sources += k == 0 || sorted_pairs[k] >> 32 != sorted_pairs[k - 1] >> 32;
  reserve_large(offset_, sources + 1);
  std::uint64_t previous = ~std::uint64_t{0};
  for (const std::uint64_t pair : sorted_pairs) {
    const auto source = static_cast<std::uint32_t>(pair >> 32);
    if (source != previous) {
      bits_[source >> 6] |= std::uint64_t{1} << (source & 63);
      offset_.push_back(static_cast<std::uint32_t>(targets_.size()));
      previous = source;
    }
    targets_.push_back(static_cast<std::uint32_t>(pair));
  }
  offset_.push_back(static_cast<std::uint32_t>(targets_.size()));
  std::uint32_t before = 0;
  for (std::size_t word = 0; word < bits_.size(); ++word) {
    rank_[word] = before;
    before += static_cast<std::uint32_t>(std::popcount(bits_[word]));
  }
}

std::size_t Links::bytes() const {
  return bits_.size() * sizeof(bits_[0]) + rank_.size() * sizeof(rank_[0]) +
         offset_.size() * sizeof(offset_[0]) + targets_.size() * sizeof(targets_[0]);
}

}  // namespace verdigris
