#include "verdigris/surface/links.hpp"

#include "verdigris/base/large_memory.hpp"

namespace verdigris {

Links::Links(std::size_t slot_count, std::span<const std::uint64_t> sorted_pairs)
    : bits_(large_vector(slot_count / 64 + 1, std::uint64_t{0})),
      first_(large_vector(slot_count / 64 + 1, std::uint32_t{0})),
      last_(large_vector(sorted_pairs.size() / 64 + 2, std::uint64_t{0})) {
  reserve_large(targets_, sorted_pairs.size());
  std::size_t word = 0;  // those up to here know where their targets begin
  for (std::size_t k = 0; k < sorted_pairs.size(); ++k) {
    const auto source = static_cast<std::uint32_t>(sorted_pairs[k] >> 32);
    while (word < source >> 6) first_[++word] = static_cast<std::uint32_t>(k);
    bits_[source >> 6] |= std::uint64_t{1} << (source & 63);
    if (k + 1 == sorted_pairs.size() || sorted_pairs[k + 1] >> 32 != source)
      last_[k >> 6] |= std::uint64_t{1} << (k & 63);
    targets_.push_back(static_cast<std::uint32_t>(sorted_pairs[k]));
  }
  while (word + 1 < first_.size()) first_[++word] = static_cast<std::uint32_t>(targets_.size());
}

std::vector<std::uint32_t> Links::sources_of_targets() const {
  std::vector<std::uint32_t> sources;
  reserve_large(sources, targets_.size());
  for_each([&](std::uint32_t source, std::span<const std::uint32_t> targets) {
    sources.insert(sources.end(), targets.size(), source);
  });
  return sources;
}

std::size_t Links::bytes() const {
  return bits_.size() * sizeof(bits_[0]) + first_.size() * sizeof(first_[0]) +
         last_.size() * sizeof(last_[0]) + targets_.size() * sizeof(targets_[0]);
}

}  // namespace verdigris
