#pragma once
// Union-find (R. Tarjan, "Efficiency of a good but not linear set union algorithm", 1975).

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace verdigris {

/// Sets of the numbers 0..size - 1. The root of a set is its smallest member, so that results do not depend
/// on order.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace verdigris
