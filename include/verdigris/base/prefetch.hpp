#pragma once
// Asking for memory before it is needed.

namespace verdigris {

/// Asks for the cache line that `address` lies in; it need not be a valid one. Functions that do nothing else
/// must be always_inline as this one is: g++ takes them for functions without effect and drops their calls.
[[gnu::always_inline]] inline void prefetch(const void* address) {
  __builtin_prefetch(address);
}
/// The same for memory that will be written.
[[gnu::always_inline]] inline void prefetch_for_writing(const void* address) {
  __builtin_prefetch(address, 1);
}

}  // namespace verdigris
