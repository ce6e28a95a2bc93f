#pragma once
#include <cstddef>
#include <cstdint>

namespace percuss {
inline namespace core {

struct ReadResult {
  std::size_t bytes = 0;  // fewer than asked for: the file ends there, or reading failed
  int error = 0;          // errno of the failure; 0 without one
};

/// Reads `bytes` bytes at an offset of a file; repeats interrupted and partial calls. Several threads may read at once.
ReadResult read_at(int descriptor, std::uint64_t offset, void* to, std::size_t bytes);

}  // namespace core
}  // namespace percuss
