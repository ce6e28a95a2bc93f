#include "acquire/sandbox/readers_memory.hpp"

#include "acquire/record/sample_limits.hpp"

namespace percuss::acquire {

void ReadersMemory::subtract(const void* reader) {
  const auto found = shares_.find(reader);
  if (found == shares_.end()) return;
  limit_bytes_ -= found->second.limit_bytes;
  taken_bytes_ -= found->second.taken_bytes;
  shares_.erase(found);
}

bool ReadersMemory::store(const void* reader, std::uint64_t file_bytes, std::uint64_t taken_bytes) {
  const Share share{claim_limit_bytes(file_bytes) - claim_limit_bytes(0), taken_bytes};
  const std::lock_guard lock(mutex_);
  subtract(reader);
  shares_.emplace(reader, share);
  limit_bytes_ += share.limit_bytes;
  taken_bytes_ += share.taken_bytes;
  return taken_bytes_ <= limit_bytes_;
}

void ReadersMemory::remove(const void* reader) {
  const std::lock_guard lock(mutex_);
  subtract(reader);
}

std::uint64_t ReadersMemory::limit_bytes() const {
  const std::lock_guard lock(mutex_);
  return limit_bytes_;
}

ReadersMemory& readers_memory() {
  static ReadersMemory memory;
  return memory;
}

}  // namespace percuss::acquire
