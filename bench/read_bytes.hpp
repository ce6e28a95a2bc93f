#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace percuss {

/// Reads all bytes of a file by read() in blocks of 128 KiB, like cat.
/// errors  std::runtime_error: the file cannot be opened.
inline void read_bytes_of(const std::string& path) {
  static std::vector<char> block(std::size_t{1} << 17U);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw std::runtime_error("cannot open " + path);
  while (::read(descriptor, block.data(), block.size()) > 0) {
  }
  ::close(descriptor);
}

}  // namespace percuss
