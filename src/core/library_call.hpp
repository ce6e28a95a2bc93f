#pragma once
#include <cstddef>

namespace percuss {
inline namespace core {

/// Marks a call of a library that crashes when memory runs out within it: FFTW, and HDF5 while it writes. The
/// command-line tool turns such a crash into its message for missing memory.
class LibraryCall {
 public:
  /// Checks that `bytes` are available on this thread's heap, so that the library hardly ever runs out. Checks nothing
  /// where the system refuses no allocation.
  /// errors  std::bad_alloc
  explicit LibraryCall(std::size_t bytes);
  LibraryCall() noexcept;  // without the check, for destructors
  ~LibraryCall();
  LibraryCall(const LibraryCall&) = delete;
  LibraryCall& operator=(const LibraryCall&) = delete;

  /// Whether this thread is within such a call. Safe in signal handlers.
  static bool running() noexcept;
};

}  // namespace core
}  // namespace percuss
