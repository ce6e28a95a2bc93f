#include "core/io/read_at.hpp"

#include <unistd.h>

#include <cerrno>

namespace percuss {
inline namespace core {

ReadResult read_at(int descriptor, std::uint64_t offset, void* to, std::size_t bytes) {
  ReadResult result;
  while (result.bytes < bytes) {
    const ssize_t got = ::pread(descriptor, static_cast<char*>(to) + result.bytes, bytes - result.bytes,
                                static_cast<off_t>(offset + result.bytes));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) result.error = errno;
    if (got <= 0) break;
    result.bytes += static_cast<std::size_t>(got);
  }
  return result;
}

}  // namespace core
}  // namespace percuss
