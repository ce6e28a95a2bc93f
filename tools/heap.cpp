#include "heap.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/parallel.hpp"

namespace percuss::tools {
namespace {

constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21U;
constexpr std::uintptr_t kThreadHeap = std::uintptr_t{1} << 26U;  // glibc's for other threads than the first, aligned
constexpr int kMainHeap = 1 << 29;                                // of addresses: memory is had page by page

// What one step gives back the next one asks for: to get its pages anew from the system would take longer than many a
// step's work.
bool keep_freed_memory() {
  constexpr int kLargest = 1 << 25, kNever = 1 << 30;  // bytes; glibc takes no larger threshold
  return ::mallopt(M_MMAP_THRESHOLD, kLargest) != 0 && ::mallopt(M_TRIM_THRESHOLD, kNever) != 0;
}

// A hint: memory stays what it is where the system follows it not.
void in_large_pages(std::uintptr_t first, std::uintptr_t end) {
  first = (first + kPage - 1) & ~(kPage - 1);
  if (first < end) ::madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}

std::uintptr_t heap_end() { return reinterpret_cast<std::uintptr_t>(::sbrk(0)); }

// Some memory of malloc's, so that there is a heap; nothing where it has none to give.
std::uintptr_t place_of_some(std::size_t bytes) {
  void* volatile const some = std::malloc(bytes);  // volatile: or the compiler leaves both out
  const auto place = reinterpret_cast<std::uintptr_t>(some);
  std::free(some);
  return place;
}

// Large pages are had where their addresses are the heap's already, so that it must not grow bit by bit. False where
// the process may not have so many addresses: it gets by with few.
bool enlarge_pages_of_main_heap() {
  constexpr std::size_t kMoreThanItHas = std::size_t{1} << 20U;
  constexpr int kFew = 1 << 17;  // as by itself
  const std::uintptr_t before = heap_end();
  ::mallopt(M_TOP_PAD, kMainHeap);
  place_of_some(kMoreThanItHas);
  const bool grown = heap_end() - before > std::uintptr_t{kMainHeap};
  ::mallopt(M_TOP_PAD, grown ? static_cast<int>(kThreadHeap) : kFew);
  if (grown) in_large_pages(before, heap_end());
  return grown;
}

void enlarge_pages_of_thread() {
  const std::uintptr_t heap = place_of_some(1) & ~(kThreadHeap - 1);
  if (heap != 0) in_large_pages(heap, heap + kThreadHeap);
}

}  // namespace

void prepare_heap() {
  if (keep_freed_memory() && enlarge_pages_of_main_heap()) greet_threads(enlarge_pages_of_thread);
}

}  // namespace percuss::tools
