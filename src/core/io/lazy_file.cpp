#include "core/io/lazy_file.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/io/input_file.hpp"
#include "core/io/read_at.hpp"

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
  const ReadResult got = read_at(descriptor_, first, to, count);
  if (got.error != 0) throw_system_error("reading failed", got.error, path_, "check the disk");
  if (got.bytes < count)
    throw InputError("the file became shorter while it was read", path_, "read it when it is complete");
}

}  // namespace core
}  // namespace percuss
