#pragma once
#include <cstdint>
#include <map>
#include <mutex>

namespace percuss::acquire {

/// The memory of all readers together. Each reader has a limit of its own, but a survey opens hundreds of files. The
/// limit of the sum is `pool_bytes` plus 64 times the bytes of all files.
class ReadersMemory {
 public:
  static constexpr std::uint64_t kPool_bytes = std::uint64_t{2} << 30U;

  explicit ReadersMemory(std::uint64_t pool_bytes = kPool_bytes) : limit_bytes_(pool_bytes) {}

  /// Stores the memory that a reader has taken. False: all readers together have taken more than their limit.
  bool store(const void* reader, std::uint64_t file_bytes, std::uint64_t taken_bytes);
  void remove(const void* reader);
  std::uint64_t limit_bytes() const;

 private:
  struct Share {
    std::uint64_t limit_bytes = 0, taken_bytes = 0;
  };

  void subtract(const void* reader);

  mutable std::mutex mutex_;
  std::map<const void*, Share> shares_;
  std::uint64_t limit_bytes_, taken_bytes_ = 0;
};

/// The readers of this process.
ReadersMemory& readers_memory();

}  // namespace percuss::acquire
