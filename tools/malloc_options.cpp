#include "malloc_options.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/parallel/parallel.hpp"

namespace percuss::tools {
namespace {

constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21U;
constexpr std::uintptr_t kThreadHeap = std::uintptr_t{1} << 26U;  // size and alignment of a thread's heap in glibc
constexpr int kMainHeap = 1 << 29;                                // bytes reserved; a page takes memory at first use
constexpr int kMinHeap = 1 << 26;                                 // below this, large pages do not pay

// Each step of an analysis allocates what the previous one freed. Fetching the pages from the system again would take
// longer than many steps.
bool keep_freed_memory() {
  constexpr int kMaxThreshold = 1 << 25, kNeverTrim = 1 << 30;  // bytes; glibc accepts no larger mmap threshold
  return ::mallopt(M_MMAP_THRESHOLD, kMaxThreshold) != 0 && ::mallopt(M_TRIM_THRESHOLD, kNeverTrim) != 0;
}

std::uintptr_t address_of(const char* pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }

// A hint: the system may ignore it.
void request_large_pages(char* first, const char* end) {
  char* const page = first + (kLargePage - address_of(first) % kLargePage) % kLargePage;
  if (page < end) ::madvise(page, static_cast<std::size_t>(end - page), MADV_HUGEPAGE);
}

char* heap_end() { return static_cast<char*>(::sbrk(0)); }

// At most a quarter of the addresses that `ulimit -v` or `ulimit -d` allow: threads, files and large arrays need the
// rest.
int largest_heap() {
  rlim_t lowest = RLIM_INFINITY;
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) == 0) lowest = std::min(lowest, limit.rlim_cur);
  }
  return lowest / 4 > kMainHeap ? kMainHeap : static_cast<int>(lowest / 4);
}

// A page is large only where the heap already owns its addresses, so the heap must not grow in small steps. Halves the
// request until the system grants it; false if the system denies even kMinHeap.
bool enlarge_main_heap() {
  constexpr std::size_t kBeyondFirstHeap = std::size_t{1} << 20U;
  constexpr int kDefaultTopPad = 1 << 17;
  char* const before = heap_end();
  bool grown = false;
  for (int heap = largest_heap(); heap >= kMinHeap && !grown; heap /= 2) {
    ::mallopt(M_TOP_PAD, heap);
    void* volatile const block = std::malloc(kBeyondFirstHeap);  // volatile: otherwise the compiler removes the call
    std::free(block);
    grown = heap_end() - before > heap;
  }
  ::mallopt(M_TOP_PAD, grown ? static_cast<int>(kThreadHeap) : kDefaultTopPad);
  if (grown) request_large_pages(before, heap_end());
  return grown;
}

void enlarge_thread_heap() {
  void* volatile const block = std::malloc(1);  // creates the heap of this thread
  char* const address = static_cast<char*>(block);
  if (address != nullptr) {
    char* const heap = address - address_of(address) % kThreadHeap;
    request_large_pages(heap, heap + kThreadHeap);
  }
  std::free(block);
}

}  // namespace

void configure_malloc() {
  if (keep_freed_memory() && enlarge_main_heap()) set_thread_initialiser(enlarge_thread_heap);
}

}  // namespace percuss::tools
