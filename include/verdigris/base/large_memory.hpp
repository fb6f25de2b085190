#pragma once
// Room for arrays of many megabytes: in huge pages, touched first by all threads.

#include <cstddef>
#include <type_traits>
#include <vector>

namespace verdigris {

/// Readies memory that nothing has been written to: asks the system for huge pages, without which cells met
/// in no order wait for page tables, and lets all threads touch it, so that it is there at once and, on
/// machines with several memories, spread over them. Does nothing with less than 4 MB. What it holds may
/// become zero.
void ready_memory(void* begin, std::size_t bytes);

/// Room for `count` elements in a vector that has none yet.
template <typename T>
void reserve_large(std::vector<T>& empty, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T>);
  empty.reserve(count);
  ready_memory(empty.data(), count * sizeof(T));
}

/// A vector of `count` equal elements.
template <typename T>
std::vector<T> large_vector(std::size_t count, const T& value) {
  std::vector<T> elements;
  reserve_large(elements, count);
  elements.resize(count, value);
  return elements;
}

/// A copy that takes no more room than it needs.
template <typename T>
std::vector<T> large_copy(const std::vector<T>& from) {
  std::vector<T> elements;
  reserve_large(elements, from.size());
  elements.insert(elements.end(), from.begin(), from.end());
  return elements;
}

}  // namespace verdigris
