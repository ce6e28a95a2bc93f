#include "core/uninitialized_array.hpp"

#include <sys/mman.h>

#include <new>

namespace percuss::inline core {

void* allocate_pages(std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{1} << 21U, kLine = 64;
  const std::size_t unit = bytes < kPage ? kLine : kPage;
  void* const memory = std::aligned_alloc(unit, (bytes + unit) / unit * unit);  // never 0 bytes
  if (memory == nullptr) throw std::bad_alloc();
  if (unit == kPage) ::madvise(memory, bytes, MADV_HUGEPAGE);  // where the system has none, small ones do
  return memory;
}

}  // namespace percuss::inline core
