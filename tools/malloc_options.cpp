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
constexpr std::uintptr_t kThreadHeap = std::uintptr_t{1}
                                       << 26U;  // size and alignment of glibc's heap for each further thread
constexpr int kMainHeap = 1 << 29;              // address space only; memory is committed page by page

// Each step allocates the memory that the previous step freed. Returning it to the system and faulting it in again
// would take longer than the work of many steps.
bool keep_freed_memory() {
  constexpr int kLargest = 1 << 25, kNever = 1 << 30;  // bytes; the largest threshold of glibc
  return ::mallopt(M_MMAP_THRESHOLD, kLargest) != 0 && ::mallopt(M_TRIM_THRESHOLD, kNever) != 0;
}

std::uintptr_t address_of(const char* place) { return reinterpret_cast<std::uintptr_t>(place); }

// A hint, which the system may ignore.
void advise_large_pages(char* first, const char* end) {
  char* const page = first + (kPage - address_of(first) % kPage) % kPage;
  if (page < end) ::madvise(page, static_cast<std::size_t>(end - page), MADV_HUGEPAGE);
}

char* heap_end() { return static_cast<char*>(::sbrk(0)); }

// Large pages require that the heap reserves its address space at once. Returns false if the process may not reserve so
// much; the heap then grows as usual.
bool enlarge_pages_of_main_heap() {
  constexpr std::size_t kMoreThanFree = std::size_t{1} << 20U;
  constexpr int kDefaultPad = 1 << 17;  // the default of glibc
  char* const before = heap_end();
  ::mallopt(M_TOP_PAD, kMainHeap);
  void* volatile const block = std::malloc(kMoreThanFree);  // volatile, so that the compiler keeps the call
  std::free(block);
  const bool grown = heap_end() - before > kMainHeap;
  ::mallopt(M_TOP_PAD, grown ? static_cast<int>(kThreadHeap) : kDefaultPad);
  if (grown) advise_large_pages(before, heap_end());
  return grown;
}

void enlarge_pages_of_thread() {
  void* volatile const block = std::malloc(1);  // creates the heap of the thread
  char* const place = static_cast<char*>(block);
  if (place != nullptr) {
    char* const heap = place - address_of(place) % kThreadHeap;
    advise_large_pages(heap, heap + kThreadHeap);
  }
  std::free(block);
}

}  // namespace

void configure_malloc() {
  if (keep_freed_memory() && enlarge_pages_of_main_heap()) set_thread_initialiser(enlarge_pages_of_thread);
}

}  // namespace percuss::tools
