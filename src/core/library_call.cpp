#include "core/library_call.hpp"

#include <sys/resource.h>

#include <cstdlib>
#include <fstream>
#include <new>

namespace percuss {
inline namespace core {
namespace {

thread_local int depth = 0;

bool is_limited(int resource) {
  rlimit limit{};
  return ::getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

// Linux gives memory without a check of what is free, except in its strict mode 2.
bool kernel_counts_memory() {
  char mode = '2';
  std::ifstream("/proc/sys/vm/overcommit_memory") >> mode;
  return mode == '2';
}

// Whether an allocation may fail. With the address sanitizer the check took a quarter of the time of an analysis of
// free decays.
bool memory_may_run_out() {
  static const bool counted = kernel_counts_memory();
  return counted || is_limited(RLIMIT_AS) || is_limited(RLIMIT_DATA);
}

void check_available(std::size_t bytes) {
  // In the tool, glibc keeps a freed block below 32 MiB (malloc_options.cpp) on the heap of this thread, from which the
  // library then allocates. A larger block may return to the system.
  void* volatile const block = std::malloc(bytes);  // volatile: otherwise the compiler removes the call
  if (block == nullptr) throw std::bad_alloc();
  std::free(block);
}

}  // namespace

LibraryCall::LibraryCall() noexcept { ++depth; }

LibraryCall::LibraryCall(std::size_t bytes) {
  if (memory_may_run_out()) check_available(bytes);
  ++depth;
}

LibraryCall::~LibraryCall() { --depth; }

bool LibraryCall::running() noexcept { return depth > 0; }

}  // namespace core
}  // namespace percuss
