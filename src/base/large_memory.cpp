#include "verdigris/base/large_memory.hpp"

#include <tbb/parallel_for.h>

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace verdigris {

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20, small_page = 4096;
constexpr int collapse = 25;  // MADV_COLLAPSE, of Linux 6.1 on; headers may be older

}  // namespace

void ready_memory(void* begin, std::size_t bytes) {
  if (bytes < 2 * huge_page) return;
  // Whole huge pages inside; what sticks out at the ends stays as it is.
  const auto address = reinterpret_cast<std::uintptr_t>(begin);
  const std::size_t skipped = (huge_page - address % huge_page) % huge_page;
  auto* first = static_cast<unsigned char*>(begin) + skipped;
  const std::size_t pages = (bytes - skipped) / huge_page;
#ifdef MADV_HUGEPAGE
  madvise(first, pages * huge_page, MADV_HUGEPAGE);  // may be refused: then pages are small
#endif
  tbb::parallel_for(std::size_t{0}, pages, [&](std::size_t page) {
    for (std::size_t at = 0; at < huge_page; at += small_page) first[page * huge_page + at] = 0;
  });
#ifdef MADV_HUGEPAGE
  // What the heap hands out once more lies in small pages already.
  madvise(first, pages * huge_page, collapse);
#endif
}

}  // namespace verdigris
