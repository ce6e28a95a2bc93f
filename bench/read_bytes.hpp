#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <string>
#include <vector>

namespace percuss {

/// Reads all bytes of a file by read() in blocks of 128 KiB, like cat.
inline void read_bytes_of(const std::string& path) {
  static std::vector<char> block(std::size_t{1} << 17U);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  while (::read(descriptor, block.data(), block.size()) > 0) {
  }
  ::close(descriptor);
}

}  // namespace percuss
