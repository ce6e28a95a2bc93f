#include "core/library_call.hpp"

#include <cstdlib>
#include <new>

namespace percuss {
inline namespace core {
namespace {

thread_local int depth = 0;

}  // namespace

LibraryCall::LibraryCall() noexcept { ++depth; }

LibraryCall::LibraryCall(std::size_t bytes) {
  // glibc keeps the freed block on the heap of this thread, from which the library then allocates.
  void* volatile const block = std::malloc(bytes);  // volatile: otherwise the compiler removes the call
  if (block == nullptr) throw std::bad_alloc();
  std::free(block);
  ++depth;
}

LibraryCall::~LibraryCall() { --depth; }

bool LibraryCall::running() noexcept { return depth > 0; }

}  // namespace core
}  // namespace percuss
