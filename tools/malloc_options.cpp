#include "malloc_options.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/parallel/parallel.hpp"

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

std::uintptr_t address_of(const char* place) { return reinterpret_cast<std::uintptr_t>(place); }

// A hint: memory stays what it is where the system follows it not.
void in_large_pages(char* first, const char* end) {
  char* const page = first + (kPage - address_of(first) % kPage) % kPage;
  if (page < end) ::madvise(page, static_cast<std::size_t>(end - page), MADV_HUGEPAGE);
}

char* heap_end() { return static_cast<char*>(::sbrk(0)); }

// Large pages are had where their addresses are the heap's already, so that it must not grow bit by bit. False where
// the process may not have so many addresses: it gets by with few.
bool enlarge_pages_of_main_heap() {
  constexpr std::size_t kMoreThanItHas = std::size_t{1} << 20U;
  constexpr int kFew = 1 << 17;  // as by itself
  char* const before = heap_end();
  ::mallopt(M_TOP_PAD, kMainHeap);
  void* volatile const some = std::malloc(kMoreThanItHas);  // volatile: or the compiler leaves it out
  std::free(some);
  const bool grown = heap_end() - before > kMainHeap;
  ::mallopt(M_TOP_PAD, grown ? static_cast<int>(kThreadHeap) : kFew);
  if (grown) in_large_pages(before, heap_end());
  return grown;
}

void enlarge_pages_of_thread() {
  void* volatile const some = std::malloc(1);  // so that it has a heap
  char* const place = static_cast<char*>(some);
  if (place != nullptr) {
    char* const heap = place - address_of(place) % kThreadHeap;
    in_large_pages(heap, heap + kThreadHeap);
  }
  std::free(some);
}

}  // namespace

void configure_malloc() {
  if (keep_freed_memory() && enlarge_pages_of_main_heap()) set_thread_initialiser(enlarge_pages_of_thread);
}

}  // namespace percuss::tools
