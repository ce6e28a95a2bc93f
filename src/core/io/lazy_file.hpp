#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace percuss {
inline namespace core {

/// A regular file with address space for all its bytes, which are read on request. Unread bytes take no memory.
class LazyFile {
 public:
  /// errors  InputError: as read_input, with the remedy kSplitRecord; no address space for a file of this size
  LazyFile(const std::string& path, std::uint64_t limit_bytes);
  ~LazyFile();
  LazyFile(const LazyFile&) = delete;
  LazyFile& operator=(const LazyFile&) = delete;

  const char* data() const { return data_; }
  std::size_t size() const { return size_; }
  /// Loads bytes first … end − 1, up to the end of the file. One thread at a time.
  void load(std::size_t first, std::size_t end);
  /// Copies bytes first … first + count − 1 to `to` without loading them. Several threads may call at the same time.
  /// errors  InputError: the file became shorter, or cannot be read
  void copy(std::size_t first, std::size_t count, char* to) const;

 private:
  std::string path_;
  int descriptor_ = -1;
  char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace core
}  // namespace percuss
