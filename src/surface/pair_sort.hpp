#pragma once
// Ordering joints by their source: a radix sort, since they come in millions.

#include <cstdint>
#include <vector>

namespace verdigris {

/// Stable sort of (source << 32 | target) pairs by source. Linear time; needs as much memory again while it
/// runs.
void sort_by_source(std::vector<std::uint64_t>& pairs, std::uint64_t source_count);

}  // namespace verdigris
