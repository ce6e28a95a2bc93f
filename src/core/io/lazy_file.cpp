#include "core/io/lazy_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "core/error.hpp"
#include "core/io/input_file.hpp"

namespace percuss {
inline namespace core {

LazyFile::LazyFile(const std::string& path, std::uint64_t limit_bytes) : path_(path) {
  std::uint64_t size = 0;
  descriptor_ = open_regular_file(path, limit_bytes, size, kSplitRecord);
  size_ = static_cast<std::size_t>(size);
  void* const place = ::mmap(nullptr, std::max<std::size_t>(1, size_), PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED) {
    ::close(descriptor_);
    throw MachineFault("not enough address space for the file", path, kSplitRecord);
  }
  data_ = static_cast<char*>(place);
}

LazyFile::~LazyFile() {
  ::munmap(data_, std::max<std::size_t>(1, size_));
  ::close(descriptor_);
}

void LazyFile::load(std::size_t first, std::size_t end) {
  end = std::min(end, size_);
  if (first < end) copy(first, end - first, data_ + first);
}

void LazyFile::copy(std::size_t first, std::size_t count, char* to) const {
  while (count > 0) {
    const auto got = ::pread(descriptor_, to, count, static_cast<off_t>(first));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw_system_error("reading failed", errno, path_, "check the disk");
    if (got == 0) throw InputError("the file became shorter while it was read", path_, "read it when it is complete");
    to += got;
    first += static_cast<std::size_t>(got);
    count -= static_cast<std::size_t>(got);
  }
}

}  // namespace core
}  // namespace percuss
