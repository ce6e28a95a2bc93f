#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace percuss::inline core {

/// A regular file with a place in memory for all of it, into which its bytes are read only as somebody asks. What has
/// not been read takes no memory.
class LazyFile {
 public:
  /// errors  InputError: as read_input; no address space for so long a file.
  LazyFile(const std::string& path, std::uint64_t limit_bytes);
  ~LazyFile();
  LazyFile(const LazyFile&) = delete;
  LazyFile& operator=(const LazyFile&) = delete;

  const char* data() const { return data_; }
  std::size_t size() const { return size_; }
  /// Reads bytes first … end − 1 (as far as there are any) into their places. One thread at a time.
  void load(std::size_t first, std::size_t end);
  /// Reads bytes first … first + count − 1 to `to`, and not into their places. Several threads may call at once.
  /// errors  InputError: the file has become shorter, or cannot be read.
  void copy(std::size_t first, std::size_t count, char* to) const;

 private:
  std::string path_;
  int descriptor_ = -1;
  char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace percuss::inline core
